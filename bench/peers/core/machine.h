/// \file
/// The machine that a run is on: what it is called, what it can do, and one core of it.
#pragma once

#include <cstddef>
#include <string>

namespace soms::bench {

/// The processor as it names itself.
[[nodiscard]] std::string processor();

/// The instruction set that soms runs on, as it says itself: SOMS_ISA where it is set.
/// \errors As `instruction_set`.
[[nodiscard]] std::string isa();

/// Name of the folder of this machine's results: processor, cores and instruction set.
[[nodiscard]] std::string machine_folder();

/// Binds this process to processor `cpu`, or to the last one it may run on if `cpu` is negative.
/// Returns the processor's number, or -1 where the system does not allow it.
int pin(int cpu);

/// Bytes held by malloc, large mapped blocks included.
[[nodiscard]] std::size_t heap_bytes();

/// Processor time of this process in seconds: on a shared machine it leaves out what others get.
[[nodiscard]] double processor_seconds();

/// Today, as 2026-01-31.
[[nodiscard]] std::string today();

}  // namespace soms::bench
