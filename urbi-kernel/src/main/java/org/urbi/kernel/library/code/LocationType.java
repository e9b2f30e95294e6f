package org.urbi.kernel.library.code;

import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Location;

/** Pieces of files, from a position to another one (manual, "Location"). */
@UrbiType(
    value = "Location",
    doc = "A piece of a file, from a position up to another one.",
    needs = Permission.NOTHING)
public final class LocationType {
  private LocationType() {}

  private static UrbiObject copy(Frame frame, CallSite site, int place, UrbiObject position) {
    if (!position.isA(position.world().prototype("Position"))) {
      throw Arguments.type(frame, site, place, position, "Position");
    }
    return frame.interpreter().send(frame, position.world().prototype("Position"), "new", position);
  }

  @Builtin(
      doc = "From a position to another one; without any, the very beginning.",
      needs = Permission.CHANGE)
  static void init(
      Frame frame,
      CallSite site,
      UrbiObject self,
      @Optional @Nullable UrbiObject begin,
      @Optional @Nullable UrbiObject end) {
    UrbiObject from = begin == null ? new Locations(self.world()).position(null, 1, 1) : begin;
    OwnSlots.put(self, "begin", copy(frame, site, 1, from));
    OwnSlots.put(self, "end", copy(frame, site, end == null ? 1 : 2, end == null ? from : end));
  }

  private static UrbiObject at(Frame frame, UrbiObject self, String which) {
    UrbiObject position = self.lookup(self.world().symbol(which));
    return position == null ? self.world().prototype("Position") : position;
  }

  @Builtin(
      value = {"=="},
      doc = "Whether both begin and end at the same positions.")
  static boolean equal(Frame frame, UrbiObject self, UrbiObject other) {
    return self == other
        || other.isA(self.world().prototype("Location"))
            && PositionType.compare(frame, at(frame, self, "begin"), at(frame, other, "begin")) == 0
            && PositionType.compare(frame, at(frame, self, "end"), at(frame, other, "end")) == 0;
  }

  @Builtin(doc = "The location as errors show it: file:1.5, file:1.5-7, file:1.5-2.3.")
  static String asString(Frame frame, UrbiObject self) {
    UrbiObject begin = at(frame, self, "begin");
    UrbiObject end = at(frame, self, "end");
    return new Location(
            PositionType.file(frame, begin),
            PositionType.number(frame, begin, "line"),
            PositionType.number(frame, begin, "column"),
            PositionType.number(frame, end, "line"),
            PositionType.number(frame, end, "column"))
        .toString();
  }
}
