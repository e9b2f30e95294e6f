package org.urbi.kernel.library.text;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** One format (manual, "FormatInfo"). */
@UrbiType(
    value = "FormatInfo",
    doc = "How to show one value: a format as of printf.",
    needs = Permission.NOTHING)
final class FormatInfoType {
  private FormatInfoType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiFormatInfo(world.values().object.cloneShape(), UrbiFormatInfo.Format.DEFAULT);
  }

  @Builtin(doc = "Makes it the format that the pattern says.", needs = Permission.CHANGE)
  static UrbiObject init(Frame caller, CallSite site, UrbiFormatInfo self, String pattern) {
    try {
      FormatParser parser = new FormatParser(pattern, 0);
      UrbiFormatInfo.Format format = parser.parse();
      if (parser.end() < pattern.length()) {
        throw new FormatParser.Malformed(
            Problem.TEXT_AFTER_FORMAT, pattern.substring(parser.end()));
      }
      self.setFormat(format);
      return self;
    } catch (FormatParser.Malformed e) {
      throw e.thrownBy(caller, site);
    }
  }

  @Builtin(doc = "-1 for aligned to the left, 0 for centered, 1 for aligned to the right.")
  static int alignment(UrbiFormatInfo self) {
    return self.format().alignment();
  }

  @Builtin(doc = "Whether the base of numbers and their decimal point are always shown.")
  static boolean alt(UrbiFormatInfo self) {
    return self.format().alternate();
  }

  @Builtin(doc = "What separates thousands.")
  static String group(UrbiFormatInfo self) {
    return self.format().group();
  }

  @Builtin(doc = "The character to fill with.")
  static String pad(UrbiFormatInfo self) {
    return String.valueOf(self.format().pad());
  }

  @Builtin(
      value = {"pattern", "asString", "asPrintable"},
      doc = "The pattern given to the constructor.")
  static String pattern(UrbiFormatInfo self) {
    return self.format().pattern();
  }

  @Builtin(doc = "The number of digits, or the greatest number of characters, to show.")
  static int precision(UrbiFormatInfo self) {
    return self.format().precisionOrDefault();
  }

  @Builtin(doc = "What is shown before positive numbers.")
  static String prefix(UrbiFormatInfo self) {
    return self.format().prefix();
  }

  @Builtin(doc = "The character of conversion, in lower case.")
  static String spec(UrbiFormatInfo self) {
    return String.valueOf(self.format().spec());
  }

  @Builtin(doc = "-1 for conversion to lower case, 1 to upper case, 0 for none.")
  static int uppercase(UrbiFormatInfo self) {
    return self.format().uppercase();
  }

  @Builtin(doc = "The least number of characters.")
  static int width(UrbiFormatInfo self) {
    return self.format().width();
  }
}
