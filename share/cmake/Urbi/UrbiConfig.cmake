# Components of urbiscript in C++:
#   find_package(Urbi REQUIRED)
#   urbi_add_uobject(machine machine.cc umachine.cc)    # machine.so, for urbi-launch and loadModule
# Urbi::uobject is what a target links with that is built in another way. Urbi_PROGRAM_DIR has the tools.
get_filename_component(_urbi_here "${CMAKE_CURRENT_LIST_FILE}" REALPATH)
get_filename_component(_urbi_root "${_urbi_here}/../../../.." ABSOLUTE)
set(Urbi_INCLUDE_DIR "${_urbi_root}/include")
set(Urbi_PROGRAM_DIR "${_urbi_root}/bin")
set(Urbi_EXECUTABLE "${_urbi_root}/urbi")

if(NOT TARGET Urbi::uobject)
  find_package(Threads REQUIRED)
  add_library(Urbi::uobject INTERFACE IMPORTED)
  set_target_properties(Urbi::uobject PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${Urbi_INCLUDE_DIR}")
  target_compile_features(Urbi::uobject INTERFACE cxx_std_17)
  # Each module has its own state of the library, also of those with the same code.
  target_compile_options(Urbi::uobject INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fno-gnu-unique>)
  target_link_libraries(Urbi::uobject INTERFACE Threads::Threads)
endif()

function(urbi_add_uobject name)
  add_library(${name} MODULE ${ARGN})
  target_link_libraries(${name} PRIVATE Urbi::uobject)
  set_target_properties(${name} PROPERTIES PREFIX "" POSITION_INDEPENDENT_CODE ON)
endfunction()
