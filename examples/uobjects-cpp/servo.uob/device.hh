#ifndef DEVICE_HH
#define DEVICE_HH

/// The servomotors of a simulated device: each goes halfway to its target with every command.
bool initialize(int id);
double getPosition(int id);
void setPosition(int id, double pos);
void setPID(int id, int p, int i, int d);

/// The gains as one number, for tests.
int gains(int id);

#endif
