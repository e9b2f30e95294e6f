/// Groups of objects.
#ifndef URBI_UOBJECT_HUB_HH
#define URBI_UOBJECT_HUB_HH

#include <string>

#include <urbi/detail/resident.hh>

namespace urbi
{
  /// Groups objects that have something to do together. Each class that UStartHub declares has one
  /// instance, with which objects register by URegister.
  class UObjectHub : public detail::Resident
  {
  public:
    explicit UObjectHub(const std::string& className);
    ~UObjectHub() override;

    void addMember(UObject* object);
    void delMember(UObject* object);

    /// The objects that have registered, in the order in which they did.
    UObjectList members;

    /// Those of a class; to be deleted by the caller.
    UObjectList* getSubClass(const std::string& className) const;

    const std::string& get_name() const
    {
      return name;
    }

  protected:
    std::string name;
  };
}

#endif
