package org.urbi.kernel.library.code;

import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.library.file.UrbiPath;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.World;

/** Places in files (manual, "Position"). */
@UrbiType(
    value = "Position",
    protos = {"Orderable"},
    doc = "A place in a file: a line and a column, counted from 1.",
    needs = Permission.NOTHING)
public final class PositionType {
  private PositionType() {}

  static UrbiObject newPrototype(World world) {
    UrbiObject prototype = world.values().object.cloned();
    fill(prototype, world.values().nil, 1, 1);
    return prototype;
  }

  private static void fill(UrbiObject self, UrbiObject file, int line, int column) {
    OwnSlots.put(self, "file", file);
    OwnSlots.put(self, "line", self.world().values().number(line));
    OwnSlots.put(self, "column", self.world().values().number(column));
  }

  /** The number of the line, or of the column. */
  static int number(Frame frame, UrbiObject self, String which) {
    return OwnSlots.get(frame, self, which) instanceof UrbiFloat number ? (int) number.value() : 1;
  }

  /** The name of the file, or null. */
  static @Nullable String file(Frame frame, UrbiObject self) {
    UrbiObject file = OwnSlots.get(frame, self, "file");
    return file == self.world().values().nil ? null : frame.interpreter().asString(frame, file);
  }

  @Builtin(
      doc = "Of another position, or of a file (which may be left out), a line, a column.",
      needs = Permission.CHANGE)
  static void init(Frame frame, CallSite site, UrbiObject self, UrbiObject... arguments) {
    switch (arguments.length) {
      case 0 -> fill(self, self.world().values().nil, 1, 1);
      case 1 -> {
        UrbiObject other = arguments[0];
        if (!other.isA(self.world().prototype("Position"))) {
          throw Arguments.type(frame, site, 1, other, "Position");
        }
        fill(
            self,
            OwnSlots.get(frame, other, "file"),
            number(frame, other, "line"),
            number(frame, other, "column"));
      }
      case 2 ->
          fill(
              self,
              self.world().values().nil,
              Arguments.integer(frame, site, 1, arguments[0]),
              Arguments.integer(frame, site, 2, arguments[1]));
      case 3 -> {
        UrbiPath paths = (UrbiPath) self.world().prototype("Path");
        UrbiObject file =
            arguments[0] instanceof UrbiString name ? paths.sibling(name.value()) : arguments[0];
        fill(
            self,
            file,
            Arguments.integer(frame, site, 2, arguments[1]),
            Arguments.integer(frame, site, 3, arguments[2]));
      }
      default -> throw frame.interpreter().errors().arity("init", arguments.length, 0, 3);
    }
  }

  private static UrbiObject moved(Frame frame, UrbiObject self, int line, int column) {
    UrbiObject made = self.world().prototype("Position").cloned();
    fill(made, OwnSlots.get(frame, self, "file"), line, Math.max(1, column));
    return made;
  }

  @Builtin(
      value = {"+", "columns"},
      doc = "The position that many columns to the right.")
  static UrbiObject plus(Frame frame, UrbiObject self, int columns) {
    return moved(frame, self, number(frame, self, "line"), number(frame, self, "column") + columns);
  }

  @Builtin(
      value = {"-"},
      doc = "The position that many columns to the left.")
  static UrbiObject minus(Frame frame, UrbiObject self, int columns) {
    return plus(frame, self, -columns);
  }

  @Builtin(doc = "The beginning of the line that many lines below.")
  static UrbiObject lines(Frame frame, UrbiObject self, int lines) {
    return moved(frame, self, number(frame, self, "line") + lines, 1);
  }

  private static boolean isPosition(UrbiObject other) {
    return other.isA(other.world().prototype("Position"));
  }

  /** Less than, equal to or greater than 0 as the first is before, at or behind the second. */
  static int compare(Frame frame, UrbiObject first, UrbiObject second) {
    int lines = Integer.compare(number(frame, first, "line"), number(frame, second, "line"));
    return lines != 0
        ? lines
        : Integer.compare(number(frame, first, "column"), number(frame, second, "column"));
  }

  @Builtin(
      value = {"=="},
      doc = "Whether lines and columns are the same.")
  static boolean equal(Frame frame, UrbiObject self, UrbiObject other) {
    return other == self || isPosition(other) && compare(frame, self, other) == 0;
  }

  @Builtin(
      value = {"<"},
      doc = "Whether the target comes before the other, whatever the files.")
  static boolean less(Frame frame, CallSite site, UrbiObject self, UrbiObject other) {
    if (!isPosition(other)) {
      throw Arguments.type(frame, site, 1, other, "Position");
    }
    return compare(frame, self, other) < 0;
  }

  @Builtin(doc = "The position as text: file:line.column.")
  static String asString(Frame frame, UrbiObject self) {
    String file = file(frame, self);
    return (file == null ? "" : file + ":")
        + number(frame, self, "line")
        + "."
        + number(frame, self, "column");
  }
}
