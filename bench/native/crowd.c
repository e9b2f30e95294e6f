/* The scene of org.urbi.bench.sim.Crowd with libode and nothing else: prints nanoseconds per step. */
#include <ode/ode.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static dWorldID world;
static dSpaceID space;
static dJointGroupID contacts;

static void near(void *data, dGeomID a, dGeomID b) {
  (void)data;
  dBodyID first = dGeomGetBody(a), second = dGeomGetBody(b);
  if (first && second && dAreConnected(first, second)) return;
  dContact c[8];
  int n = dCollide(a, b, 8, &c[0].geom, sizeof(dContact));
  for (int i = 0; i < n; i++) {
    c[i].surface.mode = dContactApprox1;
    c[i].surface.mu = 0.8;
    dJointAttach(dJointCreateContact(world, contacts, &c[i]), first, second);
  }
}

static dBodyID body(dGeomID geom, dMass mass, double x, double y, double z) {
  dBodyID made = dBodyCreate(world);
  dBodySetMass(made, &mass);
  dGeomSetBody(geom, made);
  dBodySetPosition(made, x, y, z);
  return made;
}

static dBodyID box(double m, double a, double b, double c, double x, double y, double z) {
  dMass mass;
  dMassSetBoxTotal(&mass, m, a, b, c);
  return body(dCreateBox(space, a, b, c), mass, x, y, z);
}

static void cart(double x, double y, double speed) {
  dBodyID chassis = box(2, 0.5, 0.3, 0.1, x, y, 0.2);
  for (int i = 0; i < 4; i++) {
    double wx = x + (i < 2 ? 0.2 : -0.2), wy = y + (i % 2 ? -0.2 : 0.2);
    dMass mass;
    dMassSetCylinderTotal(&mass, 0.2, 3, 0.1, 0.05);
    dBodyID wheel = body(dCreateCylinder(space, 0.1, 0.05), mass, wx, wy, 0.1);
    dMatrix3 lying;
    dRFromAxisAndAngle(lying, 1, 0, 0, M_PI / 2);
    dBodySetRotation(wheel, lying);
    dJointID axle = dJointCreateHinge(world, 0);
    dJointAttach(axle, wheel, chassis);
    dJointSetHingeAnchor(axle, wx, wy, 0.1);
    dJointSetHingeAxis(axle, 0, 1, 0);
    dJointSetHingeParam(axle, dParamVel, speed);
    dJointSetHingeParam(axle, dParamFMax, 1);
  }
}

static void step(int quick) {
  dSpaceCollide(space, 0, near);
  if (quick) dWorldQuickStep(world, 0.001); else dWorldStep(world, 0.001);
  dJointGroupEmpty(contacts);
}

static void ignore(int number, const char *text, va_list rest) {
  (void)number; (void)text; (void)rest;
}

int main(int argc, char **argv) {
  int quick = argc > 1 && argv[1][0] == 'q', steps = argc > 2 ? atoi(argv[2]) : 2000;
  dInitODE2(0);
  dSetMessageHandler(ignore);
  world = dWorldCreate();
  space = dSweepAndPruneSpaceCreate(0, dSAP_AXES_XYZ);
  contacts = dJointGroupCreate(0);
  dWorldSetGravity(world, 0, 0, -9.81);
  dWorldSetCFM(world, 1e-7);
  dWorldSetQuickStepNumIterations(world, 20);
  dCreatePlane(space, 0, 0, 1, 0);
  for (int i = 0; i < 15; i++) cart(i % 4, i / 4, i % 2 ? -1 : 1);
  for (int i = 0; i < 25; i++) {
    double x = -1 - 0.4 * (i % 5), y = 0.4 * (i / 5);
    if (i % 2) {
      box(1, 0.2, 0.2, 0.2, x, y, 0.3);
    } else {
      dMass mass;
      dMassSetSphereTotal(&mass, 1, 0.1);
      body(dCreateSphere(space, 0.1), mass, x, y, 0.3);
    }
  }
  for (int i = 0; i < 1000; i++) step(quick);
  struct timespec a, b;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &a);
  for (int i = 0; i < steps; i++) step(quick);
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &b);
  printf("%.0f\n", ((b.tv_sec - a.tv_sec) * 1e9 + (b.tv_nsec - a.tv_nsec)) / steps);
  return 0;
}
