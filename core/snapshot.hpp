#pragma once
// The whole State as bytes: canonical, so that equal worlds give equal bytes on every machine; exact, so that a world
// restored and continued equals one that never stopped.
//
//   "EVILWRLD"  version (u32)  length of payload (u64)  payload  hash of payload (u64)        all little-endian
#include "world.hpp"
#include <span>

namespace evil {

// Goes up with each change of the layout; bytes of another number are refused. tests/test_layout_of_snapshots.py watches.
inline constexpr std::uint32_t kSnapshotVersion = 8;

std::size_t snapshot_size(const World& world);                        // bytes
void write_snapshot(const World& world, std::span<std::uint8_t> out); // `out` of just that size
std::uint64_t checksum(const World& world);

// The same State in parts, so that two runs that part ways can be told where: 64 bits each, cheap enough for every step.
struct Sums {
    std::uint64_t bodies = 0;   // with their shapes
    std::uint64_t contacts = 0; // and who touches whom
    std::uint64_t forces = 0;   // with joints, and gravity
};
Sums sums(const World& world);

enum class SnapshotProblem { none, not_a_snapshot, other_version, cut_short, damaged, inconsistent };

// Restoring has two halves, so that whoever keeps more than the core can refuse before anything has changed.
struct SavedState;
struct ReadSnapshot {
    std::shared_ptr<SavedState> state; // null with a problem
    SnapshotProblem problem = SnapshotProblem::none;
};
ReadSnapshot read_snapshot(std::span<const std::uint8_t> bytes);
std::vector<std::string> notes_of(const SavedState& saved); // of the forces written in Python
struct SavedSlots {                                         // which are taken
    std::vector<std::uint32_t> bodies, shapes, forces, joints, smokes, sources, waters, streams, liquids;
    std::vector<std::uint32_t> shape_bodies; // of each of the shapes, the body that it is on
};
SavedSlots slots_of(const SavedState& saved);

// Become what was saved; `saved` is used up. Objects that are the same before and after keep their references; every
// other reference becomes stale.
void restore(World& world, SavedState& saved);

} // namespace evil
