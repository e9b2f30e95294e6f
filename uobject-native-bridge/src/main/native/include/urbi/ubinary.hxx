/// What urbi/ubinary.hh declares is defined there; this name is that of 2.7.
#include <urbi/ubinary.hh>
