/// What urbi/uobject.hh and urbi/uobject-hub.hh declare.
#ifndef URBI_DETAIL_UOBJECT_HXX
#define URBI_DETAIL_UOBJECT_HXX

#include <algorithm>

namespace urbi
{
  template <typename S>
  UGenericCallback* UObject::callback_(const std::string& type, const std::string& name,
                                       UVar* target, const S& function)
  {
    if (type == "function")
      return bind(own_slot(name), function.function(), nullptr);
    if (type == "event")
      return bindAt(own_slot(name), function, nullptr);
    if (type != "var" && type != "varaccess")
      throw std::runtime_error("unknown kind of callback: " + type);
    urbi_request operation = type == "var" ? URBI_VARIABLE_CHANGE : URBI_VARIABLE_ACCESS;
    return target ? notifySigned(operation, *target, function, nullptr)
                  : notifySigned(operation, name, function, nullptr);
  }

  template <typename S, typename E>
  UGenericCallback* UObject::callback_(const std::string& type, const std::string& name,
                                       const S& function, const E& end)
  {
    if (type != "eventend")
      throw std::runtime_error("unknown kind of callback: " + type);
    return bindAtEnd(own_slot(name), function, end, nullptr);
  }
}

#endif
