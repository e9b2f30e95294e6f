package org.urbi.sim.physics;

import org.urbi.sim.geometry.Vec3;

/** The first shape that a ray hits. */
public record RayHit(Body body, int part, double distance, Vec3 position, Vec3 normal) {}
