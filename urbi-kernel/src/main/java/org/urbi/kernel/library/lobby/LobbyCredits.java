package org.urbi.kernel.library.lobby;

import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.outside.Outside;

/** The texts of a lobby about this software (manual, "Lobby": {@code banner}, {@code authors}…). */
@UrbiTypePart(value = "Lobby", needs = Permission.NOTHING)
final class LobbyCredits {
  private static final String STARS = "********************************************************";

  private final Outside outside;

  LobbyCredits(Outside outside) {
    this.outside = outside;
  }

  private static void say(Frame frame, UrbiObject self, String... lines) {
    for (String line : lines) {
      LobbyType.output(frame, LobbyType.own(frame, self))
          .send("", line.isEmpty() ? "***" : "*** " + line);
    }
  }

  private static String version(Frame frame) {
    return frame
        .interpreter()
        .asString(
            frame,
            frame
                .interpreter()
                .send(
                    frame,
                    frame.interpreter().world().prototype("System"),
                    "implementationVersion"));
  }

  @Builtin(doc = "Tells who made Urbi.")
  static void authors(Frame frame, UrbiObject self) {
    say(
        frame,
        self,
        "Authors of Urbi:",
        " - Jean-Christophe Baillie (original designer)",
        "",
        "Urbi 2 and subsequent versions:",
        " - Akim Demaille",
        " - Matthieu Nottale",
        " - Quentin Hocquet",
        "",
        "See also `thanks;'.");
  }

  @Builtin(doc = "Tells to whom this implementation is indebted.")
  static void thanks(Frame frame, UrbiObject self) {
    say(
        frame,
        self,
        "This is Urbi on the JVM, which owes what it is to Urbi SDK,",
        "to all those who contributed to it and wrote its manual.",
        "",
        "See also `authors;'.");
  }

  @Builtin(doc = "Tells the version and who holds the rights, of the parts as well if deep.")
  void copyright(Frame frame, UrbiObject self, @Optional @Nullable UrbiObject deep) {
    String version = version(frame);
    say(
        frame,
        self,
        "Urbi version " + version + " (Urbi on the JVM)",
        "Copyright (C) 2026 the Urbi on the JVM authors.");
    if (deep == null || Truth.of(frame, deep)) {
      say(
          frame,
          self,
          "",
          "Java version " + outside.property("java.version"),
          "Provided by " + outside.property("java.vendor") + ".");
    }
  }

  @Builtin(doc = "Tells under which conditions this software may be used.")
  static void license(Frame frame, UrbiObject self) {
    say(
        frame,
        self,
        "Urbi on the JVM may be used, modified and distributed under the",
        "conditions of the BSD 3-Clause License: see the file LICENSE that comes",
        "with it.  It is provided as is, without warranty of any kind.");
  }

  @Builtin(doc = "Greets.")
  void banner(Frame frame, UrbiObject self) {
    say(frame, self, STARS);
    copyright(frame, self, self.world().values().falseObject);
    say(
        frame,
        self,
        "",
        "This program comes with ABSOLUTELY NO WARRANTY.  Type",
        "`license;', `authors;', or `copyright;' for more information.",
        STARS);
  }
}
