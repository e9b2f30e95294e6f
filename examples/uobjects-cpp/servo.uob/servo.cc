#include <urbi/uobject.hh>

#include "device.hh"

/// A servomotor whose position is both commanded and sensed by one variable.
class servo : public urbi::UObject
{
public:
  servo(const std::string&);

  int init(int id);

  urbi::UVar val;
  urbi::UVar P;
  urbi::UVar I;
  urbi::UVar D;

  void valueChanged(UVar& v);
  void valueAccessed(UVar& v);
  void pidChanged(UVar& v);
  void setPID(int p, int i, int d);
  int gains();

  int id_;
};

servo::servo(const std::string& s)
  : urbi::UObject(s)
  , id_(-1)
{
  UBindFunction(servo, init);
}

int servo::init(int id)
{
  id_ = id;
  if (!initialize(id))
    return 1;

  UBindVar(servo, val);
  // It is a sensor and an actuator.
  UOwned(val);
  val.blend = urbi::UMIX;
  UBindVars(servo, P, I, D);
  P = I = D = 0;
  UBindFunctions(servo, setPID, gains);

  UNotifyChange(val, &servo::valueChanged);
  UNotifyAccess(val, &servo::valueAccessed);
  UNotifyChange(P, &servo::pidChanged);
  UNotifyChange(I, &servo::pidChanged);
  UNotifyChange(D, &servo::pidChanged);
  return 0;
}

void servo::valueChanged(urbi::UVar& v)
{
  setPosition(id_, (double) v);
}

void servo::valueAccessed(urbi::UVar&)
{
  val = getPosition(id_);
}

void servo::pidChanged(urbi::UVar&)
{
  ::setPID(id_, (int) P, (int) I, (int) D);
}

void servo::setPID(int p, int i, int d)
{
  ::setPID(id_, p, i, d);
  P = p;
  I = i;
  D = d;
}

int servo::gains()
{
  return ::gains(id_);
}

UStart(servo);
