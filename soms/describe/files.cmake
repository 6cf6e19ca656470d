set(SOMS_HEADERS
  columns.h
  field_count.h
  fields.h
  print_answers.h
)
