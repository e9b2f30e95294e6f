/// The code of objects and of what belongs to them, see export.hh.
#include <urbi/uobject.hh>

#include <urbi/detail/code/async-call.hh>
#include <urbi/detail/code/host.hh>
#include <urbi/detail/code/resident.hh>
#include <urbi/detail/code/ucallbacks.hh>
#include <urbi/detail/code/ucontext.hh>
#include <urbi/detail/code/uevent.hh>
#include <urbi/detail/code/uobject.hh>
#include <urbi/detail/code/ustarter.hh>
#include <urbi/detail/code/uvar.hh>
#include <urbi/detail/entry.hh>
