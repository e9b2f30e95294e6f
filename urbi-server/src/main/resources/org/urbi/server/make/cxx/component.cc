#include <urbi/uobject.hh>

/// A component: what urbiscript sees of it is bound in the constructor.
class {{CLASS}} : public urbi::UObject
{
public:
  {{CLASS}}(const std::string& name)
    : urbi::UObject(name)
  {
    UBindVar({{CLASS}}, val);
    val = 0;
    UBindFunction({{CLASS}}, add);
  }

  /// Adds to val, and returns what it has become.
  double add(double summand)
  {
    val = double(val) + summand;
    return val;
  }

private:
  urbi::UVar val;
};

UStart({{CLASS}});
