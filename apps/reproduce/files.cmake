set(SOMS_REPRODUCE_FILES
  main.cpp
  reproduce.cpp
  reproduce.h
)
