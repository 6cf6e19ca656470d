#include "web/bridge/answer.h"

#include "web/bridge/export.h"

#include <malloc.h>

#include <cstdlib>

using soms::web::Answer;

SOMS_EXPORT(soms_answer_columns) std::uint32_t soms_answer_columns(const Answer* answer) {
  return static_cast<std::uint32_t>(answer->columns().size());
}

/// The column `k`: address, count of numbers, and what they are, three words each.
SOMS_EXPORT(soms_answer_column)

const Answer::Column* soms_answer_column(const Answer* answer, std::uint32_t k) {
  return &answer->columns()[k];
}

SOMS_EXPORT(soms_answer_free) void soms_answer_free(Answer* answer) {
  delete answer;
}

/// Memory for what the caller hands in; null where there is none left.
SOMS_EXPORT(soms_allocate) void* soms_allocate(std::uint32_t bytes) {
  return std::malloc(bytes);
}

SOMS_EXPORT(soms_release) void soms_release(void* memory) {
  std::free(memory);
}

/// Bytes that are allocated and not freed.
SOMS_EXPORT(soms_memory_in_use) std::uint32_t soms_memory_in_use() {
  return static_cast<std::uint32_t>(mallinfo().uordblks);
}
