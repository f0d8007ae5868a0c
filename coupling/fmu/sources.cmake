# What goes into an FMU's library beside gearset, bearing and the participants of coupling/system: Eigen, Boost
# headers and the standard library, no more.
set(ORBEARING_FMU_CORE
  guard.cpp
  instance.cpp
  model.cpp
  model_file.cpp
  number_table.cpp
  setup_numbers.cpp
  shown_members.cpp)
# The C interfaces, whose names an importer of others in the same program must not meet.
set(ORBEARING_FMU_INTERFACE fmi2.cpp fmi3.cpp fmi3_refusing.cpp)
