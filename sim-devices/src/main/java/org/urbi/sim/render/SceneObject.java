package org.urbi.sim.render;

import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Shape;

/** A shape at its place in the world. */
public record SceneObject(Shape shape, Pose pose, Appearance appearance) {}
