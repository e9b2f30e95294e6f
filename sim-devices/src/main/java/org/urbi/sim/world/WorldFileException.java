package org.urbi.sim.world;

import org.jspecify.annotations.Nullable;
import org.urbi.sim.SimulationException;

/** A mistake in a world file: {@code FILE:LINE.COLUMN: what is wrong}. */
public final class WorldFileException extends SimulationException {
  private static final long serialVersionUID = 1L;

  WorldFileException(Place place, @Nullable String message) {
    super(place + ": " + message);
  }

  /** Where something is written; lines and columns count from 1. */
  record Place(String file, int line, int column) {
    @Override
    public String toString() {
      return file + ":" + line + "." + column;
    }
  }
}
