#pragma once
#include "math/cpu.hpp"
#include "solver/contact_blocks.hpp"

// Kernels over rows of bodies and blocks of contacts, blocks that share no body which contacts change. `bodies` are the rows that the blocks' numbers mean.
// Each comes in two forms: between two bodies, and at `walls`, where a is not changed by contacts and not written.
namespace evil {
struct Contact;
EVIL_WIDE(void push_bodies(SolverBody* bodies, const ForceStep* force_steps, std::size_t count) noexcept;
          void move_bodies(SolverBody* bodies, std::size_t count, float h) noexcept;
          void fill_blocks(const SolverBody* bodies, const Contact* contacts, ContactBlock* blocks,
                           BlockSource* sources, std::size_t count) noexcept;
          void store_impulses(const ContactBlock* blocks, const BlockSource* sources, Contact* contacts,
                              std::size_t count) noexcept;
          void warm_start(SolverBody* bodies, ContactBlock* blocks, std::size_t count) noexcept;
          void warm_start_walls(SolverBody* bodies, ContactBlock* blocks, std::size_t count) noexcept;
          void push_apart(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h,
                          ContactSoftness soft) noexcept;
          void push_apart_walls(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h,
                                ContactSoftness soft) noexcept;
          void relax(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h) noexcept;
          void relax_walls(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h) noexcept;)
} // namespace evil
