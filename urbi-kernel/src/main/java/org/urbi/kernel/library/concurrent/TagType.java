package org.urbi.kernel.library.concurrent;

import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.event.Emission;
import org.urbi.kernel.event.Subscription;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.library.object.ObjectType;
import org.urbi.kernel.lobby.Output;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.PermissionCheck;
import org.urbi.kernel.node.ScopeEnd;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.tag.UrbiTag;

/** Labels of code, to control it (manual, "Tag"). */
@UrbiType(
    value = "Tag",
    doc = "A label of code, to stop, block or freeze it.",
    needs = Permission.NOTHING)
public final class TagType {
  private TagType() {}

  @Builtin(doc = "Gives the tag a name; without one it gets a number.", needs = Permission.CHANGE)
  static void init(Frame frame, UrbiTag self, @Optional @Nullable String name) {
    Symbol slot = self.world().symbol("name");
    String chosen = name == null ? "tag_" + frame.job().scheduler().nextNumber() : name;
    if (self.localSlot(slot) == null) {
      self.addSlot(slot, frame.interpreter().values().string(chosen));
    }
    PermissionCheck.claim(frame, self);
  }

  @Builtin(doc = "The tag as text: Tag<name>.")
  static String asString(Frame frame, UrbiTag self) {
    if (self == frame.interpreter().prototypes().tag) {
      return "Tag";
    }
    UrbiObject name = self.lookup(self.world().symbol("name"));
    return name instanceof UrbiString text
        ? "Tag<" + text.value() + ">"
        : ObjectType.asString(frame, self);
  }

  private static UrbiObject result(Frame frame, @Nullable UrbiObject result) {
    return result == null ? frame.interpreter().values().voidObject : result;
  }

  @Builtin(doc = "A new tag that is stopped when the scope around the call is left.")
  static UrbiObject scope(Frame frame, UrbiObject self) {
    return ofScope(frame);
  }

  /** A new tag, stopped when the scope being executed is left; at the top, the connection's. */
  public static UrbiObject ofScope(Frame frame) {
    ScopeEnd end = frame.scopeEnd();
    if (end == null) {
      return ((UrbiLobby) frame.job().lobby()).connectionTag();
    }
    UrbiTag tag = (UrbiTag) frame.interpreter().prototypes().tag.cloned();
    PermissionCheck.claim(frame, tag);
    end.add(
        () -> tag.state().stop(frame.job().scheduler(), frame.interpreter().values().voidObject));
    return tag;
  }

  @Builtin(
      doc = "Ends the code under the tag, which returns that value.",
      needs = Permission.CHANGE)
  static void stop(
      Frame frame, CallSite site, UrbiTag self, @Optional @Nullable UrbiObject result) {
    PermissionCheck.checkControl(frame, site.calledName(), self.state());
    self.state().stop(frame.job().scheduler(), result(frame, result));
    frame.job().checkInjected();
  }

  @Builtin(
      doc = "Ends the code under the tag, and lets none begin; it returns that value.",
      needs = Permission.CHANGE)
  static void block(
      Frame frame, CallSite site, UrbiTag self, @Optional @Nullable UrbiObject result) {
    PermissionCheck.checkControl(frame, site.calledName(), self.state());
    self.state().block(frame.job().scheduler(), result(frame, result));
    frame.job().checkInjected();
  }

  @Builtin(doc = "Lets code under the tag begin again.", needs = Permission.CHANGE)
  static void unblock(UrbiTag self) {
    self.state().unblock();
  }

  @Builtin(doc = "Whether no code can begin under the tag.")
  static boolean blocked(UrbiTag self) {
    return self.state().isBlocked();
  }

  @Builtin(
      doc = "Suspends the code under the tag, and the code that enters it.",
      needs = Permission.CHANGE)
  static void freeze(Frame frame, CallSite site, UrbiTag self) {
    PermissionCheck.checkControl(frame, site.calledName(), self.state());
    self.state().freeze();
    frame.job().waitWhileFrozen();
  }

  @Builtin(doc = "Lets the code under the tag go on.", needs = Permission.CHANGE)
  static void unfreeze(UrbiTag self) {
    self.state().unfreeze();
  }

  @Builtin(doc = "Whether the code under the tag is suspended.")
  static boolean frozen(UrbiTag self) {
    return self.state().isFrozen();
  }

  @Builtin(doc = "The tag which this one stands under, and which controls it too; or nil.")
  static UrbiObject getParent(Frame frame, UrbiTag self) {
    return self.parent() == null ? frame.interpreter().values().nil : self.parent();
  }

  @Builtin(doc = "The priority of the code under the tag: 0 unless it was set.")
  static double priority(UrbiTag self) {
    return self.priority();
  }

  @Builtin(
      doc = "Has code that enters the tag from now on run before all code of a lower priority.",
      needs = Permission.CHANGE)
  static void setPriority(UrbiTag self, double priority) {
    self.setPriority(Math.max(0, priority));
  }

  @Builtin(doc = "An event emitted each time code enters the tag.")
  static UrbiEvent enter(Frame frame, UrbiTag self) {
    UrbiEvent known = self.enterEvent();
    if (known == null) {
      known = event(frame, self);
      self.setEnterEvent(known);
    }
    return known;
  }

  @Builtin(doc = "An event emitted each time code leaves the tag.")
  static UrbiEvent leave(Frame frame, UrbiTag self) {
    UrbiEvent known = self.leaveEvent();
    if (known == null) {
      known = event(frame, self);
      self.setLeaveEvent(known);
    }
    return known;
  }

  /** A new event of a tag, which belongs to the tag's own lobby, whoever asks for it first. */
  private static UrbiEvent event(Frame frame, UrbiTag self) {
    UrbiEvent made = (UrbiEvent) frame.interpreter().prototypes().event.cloned();
    made.takeOwnerOf(self);
    return made;
  }

  @Builtin(doc = "A tag under this one which tells when code enters it.")
  static UrbiObject begin(Frame frame, UrbiTag self) {
    UrbiTag told = (UrbiTag) self.cloned();
    enter(frame, told).subscribe(new EmissionNotifier(self, ": begin"), frame.job());
    return told;
  }

  @Builtin(doc = "A tag under this one which tells when code leaves it.")
  static UrbiObject end(Frame frame, UrbiTag self) {
    UrbiTag told = (UrbiTag) self.cloned();
    leave(frame, told).subscribe(new EmissionNotifier(self, ": end"), frame.job());
    return told;
  }

  /** Tells of each emission of an event. */
  private record EmissionNotifier(UrbiTag tag, String what) implements Subscription {
    @Override
    public void begin(Emission emission, Job emitter) {
      Output output = ((UrbiLobby) emitter.lobby()).output();
      if (output.isFull()) {
        // Whoever enters is not to fail for what he may know nothing of.
        return;
      }
      UrbiObject name = tag.lookup(tag.world().symbol("name"));
      String text = name instanceof UrbiString known ? known.value() : "tag";
      output.send("", "*** " + text + what);
    }

    @Override
    public void end(Emission emission, Job emitter) {
      // Entering and leaving last no time.
    }
  }
}
