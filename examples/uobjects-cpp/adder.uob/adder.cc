#include <urbi/uobject.hh>

/// Adds a variable to its argument.
class adder : public urbi::UObject
{
public:
  adder(const std::string&);

  urbi::UVar v;

  double add(double rhs) const;
};

adder::adder(const std::string& s)
  : urbi::UObject(s)
{
  UBindVar(adder, v);
  UBindFunction(adder, add);
}

double adder::add(double rhs) const
{
  return ((double) v) + rhs;
}

UStart(adder);
