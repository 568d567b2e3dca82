#pragma once
#include "math/cpu.hpp"
#include "solver/contact_blocks.hpp"

// Kernels over rows of bodies and blocks of contacts, blocks that share no body which contacts change. `bodies` are the rows that the blocks' numbers mean.
// Each comes in two forms: between two bodies, and at `walls`, where a is not changed by contacts and not written.
namespace evil {
struct Contact;
// `push_bodies` warms them up by what contacts did to each in the substep before, if `warm`. `relax` tells whether any two
// of them slide on each other, so that the next substep has to warm them up contact by contact. `store_impulses` marks the
// contacts that there is something to tell of.
EVIL_WIDE(void push_bodies(SolverBody* bodies, ForceStep* force_steps, std::size_t count, bool warm) noexcept;
          void move_bodies(SolverBody* bodies, std::size_t count, float h) noexcept;
          void fill_blocks(const SolverBody* bodies, const Contact* contacts, ContactBlock* blocks,
                           BlockSource* sources, std::size_t count) noexcept;
          void store_impulses(const ContactBlock* blocks, const BlockSource* sources, Contact* contacts,
                              std::uint8_t* marks, std::size_t count, float hit_speed) noexcept;
          void warm_start(SolverBody* bodies, ContactBlock* blocks, std::size_t count) noexcept;
          void warm_start_walls(SolverBody* bodies, ContactBlock* blocks, std::size_t count) noexcept;
          void push_apart(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h,
                          ContactSoftness soft) noexcept;
          void push_apart_walls(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h,
                                ContactSoftness soft) noexcept;
          bool relax(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h) noexcept;
          void relax_walls(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h) noexcept;)
} // namespace evil
