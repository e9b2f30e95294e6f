package org.urbi.kernel.library.text;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.library.value.Counting;
import org.urbi.kernel.library.value.Hashing;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiBinary;
import org.urbi.kernel.object.UrbiHash;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** Raw memory with a header (manual, "Binary"). */
@UrbiType(
    value = "Binary",
    doc = "Raw memory, with a header that says what it is.",
    needs = Permission.NOTHING)
public final class BinaryType {
  private BinaryType() {}

  static UrbiObject newPrototype(World world) {
    return new UrbiBinary(world.values().object.cloneShape(), "", "");
  }

  public static UrbiBinary binary(Frame frame, String keywords, String data) {
    UrbiObject prototype = frame.interpreter().world().prototype("Binary");
    return new UrbiBinary(prototype.cloneShape(), keywords, data);
  }

  @Builtin(doc = "Makes it the binary with that header and these data.", needs = Permission.CHANGE)
  static UrbiObject init(UrbiBinary self, String keywords, String data) {
    self.setKeywords(keywords);
    self.setData(data);
    return self;
  }

  @Builtin(value = "+", doc = "Both data, under the first header that is not empty.")
  static UrbiObject plus(Frame frame, UrbiBinary self, UrbiBinary that) {
    String keywords = self.keywords().isEmpty() ? that.keywords() : self.keywords();
    Counting.checkMemory(frame, (long) self.data().length() + that.data().length());
    return binary(frame, keywords, self.data() + that.data());
  }

  @Builtin(value = "==", doc = "Whether headers and data are equal.")
  static boolean equals(UrbiBinary self, UrbiObject that) {
    return that instanceof UrbiBinary other
        && self.keywords().equals(other.keywords())
        && self.data().equals(other.data());
  }

  @Builtin(doc = "A Hash, equal for equal binaries.")
  static UrbiHash hash(Frame frame, UrbiBinary self) {
    return Hashing.hash(
        frame,
        UrbiHash.mix(Hashing.code(frame, self.keywords()), Hashing.code(frame, self.data())));
  }

  @Builtin(
      value = {"asString", "asPrintable"},
      doc = "The size, the header and the data, as clients are sent them.")
  static String asString(UrbiBinary self) {
    StringBuilder out = new StringBuilder("BIN ").append(self.data().length());
    if (!self.keywords().isEmpty()) {
      out.append(' ').append(self.keywords());
    }
    return out.append('\n').append(self.data()).toString();
  }

  @Builtin(doc = "Another binary with the same header and data.")
  static UrbiObject copy(Frame frame, UrbiBinary self) {
    return binary(frame, self.keywords(), self.data());
  }

  @Builtin(doc = "The data.")
  static String data(UrbiBinary self) {
    return self.data();
  }

  @Builtin(value = "data", setter = true, doc = "Sets the data.", needs = Permission.CHANGE)
  static void setData(UrbiBinary self, String data) {
    self.setData(data);
  }

  @Builtin(doc = "Whether there are no data.")
  static boolean empty(UrbiBinary self) {
    return self.data().isEmpty();
  }

  @Builtin(doc = "The header.")
  static String keywords(UrbiBinary self) {
    return self.keywords();
  }

  @Builtin(value = "keywords", setter = true, doc = "Sets the header.", needs = Permission.CHANGE)
  static void setKeywords(UrbiBinary self, String keywords) {
    self.setKeywords(keywords);
  }
}
