package org.urbi.kernel.library.code;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.library.file.UrbiPath;
import org.urbi.kernel.object.SlotNames;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;
import org.urbi.lang.source.Location;
import org.urbi.lang.source.Span;

/** Makes pieces of source text, and positions in it, as urbiscript sees them. */
public final class Locations {
  private final World world;
  private final SlotNames ofPosition;
  private final SlotNames ofLocation;

  /** The path of the file that was needed last: most positions are in the same one. */
  private @Nullable UrbiPath last;

  private String lastFile = "";

  public Locations(World world) {
    this.world = world;
    ofPosition = new SlotNames(world.symbol("file"), world.symbol("line"), world.symbol("column"));
    ofLocation = new SlotNames(world.symbol("begin"), world.symbol("end"));
  }

  /** The location of a piece of source text. */
  public UrbiObject location(Span span) {
    Location place = span.location();
    return world
        .prototype("Location")
        .clonedWith(
            ofLocation,
            position(place.file(), place.line(), place.column()),
            position(place.file(), place.endLine(), place.endColumn()));
  }

  /**
   * A position.
   *
   * @param file null when there is none
   */
  public UrbiObject position(@Nullable String file, int line, int column) {
    return world
        .prototype("Position")
        .clonedWith(
            ofPosition,
            file == null ? world.values().nil : path(file),
            world.values().number(line),
            world.values().number(column));
  }

  private UrbiPath path(String file) {
    UrbiPath known = last;
    if (known == null || !file.equals(lastFile)) {
      known = ((UrbiPath) world.prototype("Path")).sibling(file);
      last = known;
      lastFile = file;
    }
    return known.same();
  }
}
