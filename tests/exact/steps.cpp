// Steps worlds that snapshots hold and prints what they come to, so that one build can be compared with another: other
// optimisation, another compiler, another processor.
//
//     steps COUNT FILE...      for each file and each instruction set: "FILE SET CHECKSUM"
//
// python tools/dev.py exact
#include "snapshot.hpp"
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace {

std::vector<std::uint8_t> bytes_of(const char* path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

int main(int count, char** words) {
    const int steps = count > 1 ? std::atoi(words[1]) : 0;
    for (int i = 2; i < count; ++i) {
        const std::vector<std::uint8_t> bytes = bytes_of(words[i]);
        for (evil::InstructionSet set : evil::runnable_instruction_sets()) {
            const evil::ReadSnapshot read = evil::read_snapshot(bytes);
            if (read.problem != evil::SnapshotProblem::none) {
                std::fprintf(stderr, "%s is no whole snapshot of this version\n", words[i]);
                return 1;
            }
            evil::World world;
            world.instruction_set = set;
            evil::restore(world, *read.state);
            for (int step = 0; step < steps; ++step) world.step(1.0f / 60.0f, 4);
            std::printf("%s %s %016" PRIx64 "\n", words[i], evil::name(set), evil::checksum(world));
        }
    }
}
