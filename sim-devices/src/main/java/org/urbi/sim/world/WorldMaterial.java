package org.urbi.sim.world;

import org.urbi.sim.physics.Material;
import org.urbi.sim.render.Appearance;

/** A material of a world file: how it behaves, and how it looks. */
record WorldMaterial(Material material, Appearance appearance) {
  static final WorldMaterial DEFAULT = new WorldMaterial(Material.DEFAULT, Appearance.PLAIN);
}
