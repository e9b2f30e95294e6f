package org.urbi.sim.render;

import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Shape;

/** A shape, its pose and its appearance. */
public record SceneObject(Shape shape, Pose pose, Appearance appearance) {}
