package org.urbi.sim.physics;

import org.urbi.sim.geometry.Vec3;

/** What a ray has met first. */
public record RayHit(Body body, int part, double distance, Vec3 position, Vec3 normal) {}
