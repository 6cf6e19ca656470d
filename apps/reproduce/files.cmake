set(SOMS_REPRODUCE_FILES
  main.cpp
  print_pdf.cpp
  print_pdf.h
  reproduce.cpp
  reproduce.h
)
