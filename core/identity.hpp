#pragma once
// What tells an object from another that came to the same slot, at the same step, as the same one in order, in another
// history of its world or in another world (SPEC A6): a fingerprint of what it was made from. A snapshot keeps it beside
// the State; a checksum, which says how things stand and not how they came about, leaves it out.
#include "world.hpp"

namespace evil {

std::uint64_t fingerprint(const Body& body, const std::string& tag, std::span<const NewShape> shapes);
std::uint64_t fingerprint(const NewShape& shape);
std::uint64_t fingerprint(const Force& force, const Area& area);
std::uint64_t fingerprint(const Joint& joint);

} // namespace evil
