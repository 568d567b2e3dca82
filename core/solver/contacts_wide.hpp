#pragma once
#include "math/cpu.hpp"
#include "solver/contact_blocks.hpp"

// Kernels over blocks of contacts, one block after the other. `bodies` are the rows that the blocks' numbers mean.
namespace evil {
EVIL_WIDE(void warm_start(SolverBody* bodies, const ContactBlock* blocks, std::size_t count) noexcept;
          void push_apart(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h) noexcept;
          void relax(SolverBody* bodies, ContactBlock* blocks, std::size_t count, float inv_h) noexcept;)
} // namespace evil
