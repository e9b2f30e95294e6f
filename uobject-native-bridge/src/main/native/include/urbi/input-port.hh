/// Ports are variables: see urbi/uvar.hh.
#ifndef URBI_INPUT_PORT_HH
#define URBI_INPUT_PORT_HH

#include <urbi/uvar.hh>

#endif
