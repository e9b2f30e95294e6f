package org.urbi.kernel.library.text;

import java.util.ArrayList;
import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Steps;
import org.urbi.kernel.library.value.Printing;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.World;

/** Format strings (manual, "Formatter"). */
@UrbiType(
    value = "Formatter",
    doc = "A format string, as of printf, ready to be used.",
    needs = Permission.NOTHING)
final class FormatterType {
  /** What it costs to fill in a value. */
  private static final int STEPS_FOR_PIECE = 64;

  private FormatterType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiFormatter(world.values().object.cloneShape(), List.of());
  }

  @Builtin(doc = "Cuts a format string in its pieces.", needs = Permission.CHANGE)
  static UrbiObject init(Frame caller, CallSite site, UrbiFormatter self, String format) {
    self.setPieces(cut(caller, site, format));
    return self;
  }

  private static List<UrbiObject> cut(Frame caller, CallSite site, String text) {
    World world = caller.interpreter().world();
    Shape infoShape = world.prototype("FormatInfo").cloneShape();
    List<UrbiObject> pieces = new ArrayList<>();
    StringBuilder plain = new StringBuilder();
    int at = 0;
    while (at < text.length()) {
      caller.job().worked(1);
      char c = text.charAt(at);
      if (c != '%') {
        plain.append(c);
        at++;
      } else if (text.startsWith("%%", at)) {
        plain.append('%');
        at += 2;
      } else {
        addText(world, pieces, plain);
        FormatParser parser = new FormatParser(text, at);
        try {
          pieces.add(new UrbiFormatInfo(infoShape, parser.parse()));
        } catch (FormatParser.Malformed e) {
          throw e.thrownBy(caller, site);
        }
        at = parser.end();
      }
    }
    addText(world, pieces, plain);
    return pieces;
  }

  private static void addText(World world, List<UrbiObject> pieces, StringBuilder plain) {
    if (!plain.isEmpty()) {
      pieces.add(world.values().string(plain.toString()));
      plain.setLength(0);
    }
  }

  @Builtin(doc = "The pieces: Strings, and FormatInfos.")
  static List<UrbiObject> asList(UrbiFormatter self) {
    return self.pieces();
  }

  @Builtin(
      value = {"asString", "asPrintable"},
      doc = "The pieces, to be shown.")
  static String asString(Frame caller, UrbiFormatter self) {
    return "Formatter " + Printing.container(caller, newList(caller, self.pieces()));
  }

  private static UrbiObject newList(Frame caller, List<UrbiObject> elements) {
    return caller.interpreter().world().values().list(elements);
  }

  @Builtin(value = "%", doc = "The string with the members of args, or args, in their places.")
  static String apply(Frame caller, CallSite site, UrbiFormatter self, UrbiObject args) {
    return fill(caller, site, self.pieces(), args);
  }

  private static void append(Frame caller, StringBuilder out, String piece) {
    caller.job().worked(Steps.ofCharacters(piece.length()));
    out.append(piece);
  }

  /** The string that a format string makes of arguments. */
  static String format(Frame caller, CallSite site, String format, UrbiObject args) {
    return fill(caller, site, cut(caller, site, format), args);
  }

  private static String fill(
      Frame caller, CallSite site, List<UrbiObject> pieces, UrbiObject args) {
    List<UrbiObject> values =
        args instanceof UrbiList list ? List.copyOf(list.elements()) : List.of(args);
    StringBuilder out = new StringBuilder();
    int used = 0;
    for (UrbiObject piece : pieces) {
      caller.job().worked(STEPS_FOR_PIECE);
      if (piece instanceof UrbiFormatInfo info) {
        if (used >= values.size()) {
          throw caller.error(site, Problem.TOO_FEW_FOR_FORMAT);
        }
        append(caller, out, Formatting.format(caller, site.calledName(), values.get(used++), info));
      } else {
        append(caller, out, ((UrbiString) piece).value());
      }
    }
    if (used < values.size()) {
      throw caller.error(site, Problem.TOO_MANY_FOR_FORMAT);
    }
    return out.toString();
  }
}
