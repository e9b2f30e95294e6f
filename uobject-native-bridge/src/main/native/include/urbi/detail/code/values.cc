/// The code of values, see export.hh.
#include <urbi/uobject.hh>

#include <urbi/detail/code/literal.hh>
#include <urbi/detail/code/ubinary.hh>
#include <urbi/detail/code/uvalue.hh>
#include <urbi/detail/code/wire.hh>
