package org.urbi.kernel.library.lobby;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.log.KernelLog;
import org.urbi.kernel.log.LogLevel;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.PermissionCheck;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.object.World;

/** Messages for the user and the administrator (manual, "Logger"). */
@UrbiType(
    value = "Logger",
    protos = {"Tag"},
    doc = "A category of messages for the administrator of the server.",
    needs = Permission.NOTHING)
final class LoggerType {
  private final Reports reports;

  LoggerType(KernelLog log) {
    reports = new Reports(log);
  }

  static UrbiObject newPrototype(World world) {
    return new UrbiLogger(
        world.values().object.cloneShape(), new UrbiLogger.Depth(), "Logger", null);
  }

  @Builtin(
      doc = "Of that category; the level is that of what is sent with <<.",
      needs = Permission.CHANGE)
  static void init(
      Frame frame,
      CallSite site,
      UrbiLogger self,
      @Optional @Nullable String category,
      @Optional @Nullable UrbiObject level) {
    if (category != null) {
      self.setCategory(category);
    }
    if (level != null) {
      self.setLevel(level(frame, site, level));
    }
  }

  private static LogLevel level(Frame frame, CallSite site, UrbiObject value) {
    String name = frame.interpreter().asString(frame, value);
    return Arrays.stream(LogLevel.values())
        .filter(level -> level.label().equals(name))
        .findFirst()
        .orElseThrow(() -> Arguments.type(frame, site, 2, value, "Logger.Levels"));
  }

  @Builtin(doc = "The levels of messages.")
  static UrbiObject Levels(Frame frame, UrbiObject self) {
    UrbiObject prototype = self.world().prototype("Logger");
    UrbiObject known = prototype.localSlot(self.world().symbol("levels"));
    if (known == null) {
      var values = self.world().values();
      known =
          frame
              .interpreter()
              .send(
                  frame,
                  frame.interpreter().prototypes().enumeration,
                  "new",
                  values.string("Levels"),
                  values.list(
                      Arrays.stream(LogLevel.values())
                          .map(level -> values.string(level.label()))
                          .toList()));
      claimForSystem(known);
      prototype.addSlot(self.world().symbol("levels"), known);
    }
    return known;
  }

  /** The levels are there for all, whoever asks for them first. */
  private static void claimForSystem(UrbiObject levels) {
    PermissionCheck.claimForSystem(levels);
    for (UrbiObject level : levels.localSlotValues()) {
      if (!(level instanceof Code)) {
        PermissionCheck.claimForSystem(level);
      }
    }
  }

  private UrbiObject report(
      Frame frame,
      UrbiLogger self,
      LogLevel level,
      @Nullable UrbiObject message,
      @Nullable String category) {
    String name = category == null ? self.category() : category;
    if (message == null) {
      return self.at(level, name);
    }
    if (reports.shows(level)) {
      String text = frame.interpreter().asString(frame, message);
      reports.write(frame.job(), self, Utf8Text.toJava(name), Utf8Text.toJava(text));
    }
    return self;
  }

  @Builtin(
      value = {"err", "warn", "log"},
      doc = "Reports a message that everybody is to see; returns the target.")
  UrbiObject log(
      Frame frame,
      UrbiLogger self,
      @Optional @Nullable UrbiObject message,
      @Optional @Nullable String category) {
    return report(frame, self, LogLevel.LOG, message, category);
  }

  @Builtin(doc = "Reports a message for those who follow what happens; returns the target.")
  UrbiObject trace(
      Frame frame,
      UrbiLogger self,
      @Optional @Nullable UrbiObject message,
      @Optional @Nullable String category) {
    return report(frame, self, LogLevel.TRACE, message, category);
  }

  @Builtin(doc = "Reports a message for those who look for a mistake; returns the target.")
  UrbiObject debug(
      Frame frame,
      UrbiLogger self,
      @Optional @Nullable UrbiObject message,
      @Optional @Nullable String category) {
    return report(frame, self, LogLevel.DEBUG, message, category);
  }

  @Builtin(doc = "Reports a message for those who want every detail; returns the target.")
  UrbiObject dump(
      Frame frame,
      UrbiLogger self,
      @Optional @Nullable UrbiObject message,
      @Optional @Nullable String category) {
    return report(frame, self, LogLevel.DUMP, message, category);
  }

  @Builtin(
      value = {"<<"},
      doc = "Reports a message of the category and the level of the target; returns it.")
  UrbiObject send(Frame frame, CallSite site, UrbiLogger self, UrbiObject message) {
    LogLevel level = self.level();
    if (level == null) {
      throw frame.error(site, Problem.LOGGER_UNDEFINED);
    }
    return report(frame, self, level, message, null);
  }

  @Builtin(doc = "The category.")
  static String category(UrbiLogger self) {
    return self.category();
  }

  @Builtin(doc = "Called when code under the logger begins: indents what is reported.")
  static void onEnter(Frame frame, UrbiLogger self) {
    self.indent(frame.job().lobby());
  }

  @Builtin(doc = "Called when code under the logger ends.")
  static void onLeave(Frame frame, UrbiLogger self) {
    self.unindent(frame.job().lobby());
  }

  @Builtin(doc = "The logger as text: Logger<category>.")
  static String asString(UrbiLogger self) {
    return "Logger<" + self.category() + ">";
  }
}
