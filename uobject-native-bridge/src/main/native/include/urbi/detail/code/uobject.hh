/// What urbi/uobject.hh and urbi/uobject-hub.hh declare: the code.
// Before anything else: that header includes this one where it needs it.
#include <urbi/uobject.hh>

#ifndef URBI_DETAIL_CODE_UOBJECT_HH
#define URBI_DETAIL_CODE_UOBJECT_HH

namespace urbi
{
  // ---------------------------------------------------------------- UObject

  URBI_INLINE UObject::UObject(const std::string& name, impl::UContextImpl* context)
    : Resident(context, 0)
    , derived(true)
    , remote(false)
    , autogroup(false)
    , objecthub(nullptr)
    , cloner(nullptr)
    , ended_(false)
  {
    attach(name);
  }

  URBI_INLINE UObject::UObject(impl::UContextImpl* context)
    : UObject(std::string(), context)
  {}

  URBI_INLINE UObject::UObject(int, impl::UContextImpl* context)
    : UObject(std::string(), context)
  {}

  URBI_INLINE void UObject::attach(const std::string& name)
  {
    detail::Creation*& creation = detail::thread_state().creation;
    if (creation && *creation->name == name)
    {
      __name = name;
      classname = *creation->className;
      derived = __name != classname;
      id_ = creation->id;
      creation = creation->outer;
    }
    else
    {
      detail::Request request(URBI_OBJECT_NEW, context());
      request.out.text(name);
      id_ = request.send();
      __name = request.reply().text();
      classname = "UObject";
    }
    remote = isRemoteMode();
    {
      std::lock_guard<std::mutex> guard(detail::module().lock);
      detail::enlist(detail::module().objects, context(), __name, this);
    }
    UBindVar(UObject, load);
    load = 1;
  }

  URBI_INLINE UObject::~UObject()
  {
    clean();
  }

  URBI_INLINE UGenericCallback* UObject::hold(urbi_request operation, const std::string& name,
                                         UVar* target, std::unique_ptr<detail::Callback> function,
                                         const LockSpec* lock)
  {
    UGenericCallback* made
      = new UGenericCallback(*this, operation, name, target, own(std::move(function)));
    {
      std::lock_guard<std::mutex> guard(holding_);
      held_.emplace_back(made);
    }
    made->tell(lock);
    return made;
  }

  URBI_INLINE libport::ThreadPool::rTaskLock UObject::getTaskLock(LockSpec lock, const std::string&)
  {
    if (lock.lockMode == LOCK_NONE)
      return libport::ThreadPool::rTaskLock();
    return libport::ThreadPool::rTaskLock(
      new libport::ThreadPool::TaskLock(lock.maxQueueSize, lock.lockMode));
  }

  URBI_INLINE void UObject::clean()
  {
    if (objecthub)
    {
      detail::Module& module = detail::module();
      std::list<UObjectHub*> hubs;
      {
        std::lock_guard<std::mutex> guard(module.lock);
        for (const auto& entry : module.hubs)
          hubs.push_back(entry.second);
      }
      for (UObjectHub* hub : hubs)
        hub->delMember(this);
      objecthub = nullptr;
    }
    {
      std::lock_guard<std::mutex> guard(detail::module().lock);
      auto found = detail::module().objects.find({context(), __name});
      if (found != detail::module().objects.end() && found->second == this)
        detail::module().objects.erase(found);
    }
    if (ended_)
      return;
    ended_ = true;
    try
    {
      detail::Request(URBI_OBJECT_GONE, context(), id_).send();
    }
    catch (const std::exception&)
    {
      // The host has gone before.
    }
  }

  URBI_INLINE void UObject::addAutoGroup()
  {
    UJoinGroup(classname + "s");
  }

  URBI_INLINE std::string UObject::at(const std::string& event)
  {
    return "__at_" + event;
  }

  URBI_INLINE std::string UObject::at_end(const std::string& event)
  {
    return "__atEnd_" + event;
  }

  URBI_INLINE std::string UObject::own_slot(const std::string& name) const
  {
    std::string prefix = __name + ".";
    return name.compare(0, prefix.size(), prefix) == 0 ? name.substr(prefix.size()) : name;
  }

  URBI_INLINE libport::ThreadPool::rTaskLock UObject::getClassTaskLock()
  {
    return libport::ThreadPool::rTaskLock();
  }

  URBI_INLINE void UObject::register_(const std::string& hubClass)
  {
    UObjectHub* hub = getUObjectHub(hubClass);
    if (!hub)
      throw std::runtime_error("hub name '" + hubClass + "' is unknown");
    hub->addMember(this);
    objecthub = hub;
  }

  URBI_INLINE void UObject::listen(const std::string& event, size_t arity, bool end)
  {
    UEvent(*this, event);
    std::string parameters;
    std::string arguments;
    for (size_t i = 0; i < arity; ++i)
    {
      std::string name = "a" + std::to_string(i);
      parameters += (i ? ", var " : "var ") + name;
      arguments += (i ? ", " : "") + name;
    }
    // The functions go with this object, and the event may stay.
    std::string self = "uobjects." + __name;
    auto call = [&self](const std::string& function, const std::string& with) {
      return "{ if (uobjects.hasSlot(\"" + self.substr(9) + "\") && " + self + ".hasLocalSlot(\""
             + function + "\")) " + self + ".getSlotValue(\"" + function + "\").apply([" + self
             + (with.empty() ? "" : ", " + with) + "]) }";
    };
    send("at (" + self + "." + event + "?(" + parameters + ")) " + call(at(event), arguments)
         + (end ? " onleave " + call(at_end(event), "") : "") + ";");
  }

  URBI_INLINE void UObject::UJoinGroup(const std::string& groupName)
  {
    send("if (!Global.hasLocalSlot(\"" + groupName + "\")) var Global." + groupName
         + " = Group.new()|; Global." + groupName + ".add(uobjects." + __name + ")|;");
  }

  // ---------------------------------------------------------------- UObjectHub

  URBI_INLINE UObjectHub::UObjectHub(const std::string& className)
    : Resident(nullptr, 0)
    , name(className)
  {
    detail::Creation*& creation = detail::thread_state().creation;
    if (creation && *creation->name == className)
    {
      id_ = creation->id;
      creation = creation->outer;
    }
    std::lock_guard<std::mutex> guard(detail::module().lock);
    detail::enlist(detail::module().hubs, context(), name, this);
  }

  URBI_INLINE UObjectHub::~UObjectHub()
  {
    std::lock_guard<std::mutex> guard(detail::module().lock);
    auto found = detail::module().hubs.find({context(), name});
    if (found != detail::module().hubs.end() && found->second == this)
      detail::module().hubs.erase(found);
  }

  URBI_INLINE void UObjectHub::addMember(UObject* object)
  {
    if (std::find(members.begin(), members.end(), object) == members.end())
      members.push_back(object);
  }

  URBI_INLINE void UObjectHub::delMember(UObject* object)
  {
    members.remove(object);
  }

  URBI_INLINE UObjectList* UObjectHub::getSubClass(const std::string& className) const
  {
    UObjectList* found = new UObjectList();
    for (UObject* object : members)
      if (object->classname == className)
        found->push_back(object);
    return found;
  }

  // ---------------------------------------------------------------- finding them

  namespace detail
  {
    URBI_INLINE UObject* find_object(int64_t context, const std::string& name)
    {
      {
        std::lock_guard<std::mutex> guard(module().lock);
        auto found = module().objects.find({context, name});
        if (found != module().objects.end())
          return found->second;
      }
      Request request(URBI_OBJECT_FIND, context);
      request.out.text(name);
      return reinterpret_cast<UObject*>(static_cast<intptr_t>(request.send()));
    }

    URBI_INLINE UObjectHub* find_hub(int64_t context, const std::string& name)
    {
      {
        std::lock_guard<std::mutex> guard(module().lock);
        auto found = module().hubs.find({context, name});
        if (found != module().hubs.end())
          return found->second;
      }
      Request request(URBI_HUB_FIND, context);
      request.out.text(name);
      return reinterpret_cast<UObjectHub*>(static_cast<intptr_t>(request.send()));
    }

    URBI_INLINE UObject* object_of(const UValue& value)
    {
      if (value.type != DATA_STRING && value.type != DATA_SLOTNAME)
        bad_cast("UObject", value);
      UObject* found = find_object(current_context(), *value.stringValue);
      if (!found && value.type == DATA_STRING)
        bad_cast("UObject", value);
      return found;
    }

    URBI_INLINE UValue name_of(const UObject* object)
    {
      UValue name(object ? object->__name : "nil");
      name.type = DATA_SLOTNAME;
      return name;
    }

    URBI_INLINE UValue name_of(const UVar& variable)
    {
      UValue name(variable.get_name());
      name.type = DATA_SLOTNAME;
      return name;
    }
  }

  URBI_INLINE UObject* impl::UContextImpl::getUObject(const std::string& name)
  {
    return detail::find_object(number_, name);
  }

  URBI_INLINE UObjectHub* impl::UContextImpl::getUObjectHub(const std::string& name)
  {
    return detail::find_hub(number_, name);
  }

  URBI_INLINE UObject* UContext::getUObject(const std::string& name) const
  {
    return detail::find_object(context(), name);
  }

  URBI_INLINE UObjectHub* UContext::getUObjectHub(const std::string& className) const
  {
    return detail::find_hub(context(), className);
  }

  URBI_INLINE UObject* getUObject(const std::string& name)
  {
    return detail::find_object(detail::current_context(), name);
  }

  URBI_INLINE UObjectHub* getUObjectHub(const std::string& className)
  {
    return detail::find_hub(detail::current_context(), className);
  }

  // ---------------------------------------------------------------- their variables and events

  URBI_INLINE UVar::UVar(UObject& object, const std::string& slot, impl::UContextImpl* context)
    : UVar()
  {
    init(object.__name, slot, context ? context : object.ctx_);
  }

  URBI_INLINE UVar::UVar(UObject* object, const std::string& slot)
    : UVar(*object, slot)
  {}

  URBI_INLINE InputPort::InputPort(UObject* object, const std::string& slot, impl::UContextImpl* context)
    : InputPort()
  {
    init(object, slot, context);
  }

  URBI_INLINE void InputPort::init(UObject* object, const std::string& slot, impl::UContextImpl* context)
  {
    UVar::init(object->__name, slot, context ? context : object->ctx_);
  }

  URBI_INLINE UEvent::UEvent(UObject& object, const std::string& slot, impl::UContextImpl* context)
    : UEvent(object.__name, slot, context ? context : object.ctx_)
  {}
}

#endif
