package org.urbi.kernel.library.uobject;

import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.external.ExternalProcess;
import org.urbi.kernel.library.lobby.LobbyType;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.PermissionCheck;
import org.urbi.kernel.node.TakenCode;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;
import org.urbi.kernel.object.World;
import org.urbi.kernel.uobject.PluggedContext;
import org.urbi.kernel.variable.Datum;
import org.urbi.kernel.variable.Hook;
import org.urbi.kernel.variable.UrbiConnection;
import org.urbi.kernel.variable.UrbiUVar;

/** Variables that can be hooked (manual, "UVar"). */
@UrbiType(
    value = "UVar",
    doc = "A variable whose changes and accesses can be hooked.",
    needs = Permission.NOTHING)
final class UVarType {
  private static final double NANOSECONDS_PER_SECOND = 1e9;

  private final PluggedContext uobjects;

  UVarType(PluggedContext uobjects) {
    this.uobjects = uobjects;
  }

  static UrbiObject newPrototype(World world) {
    return new UrbiUVar(world.values().object.cloneShape());
  }

  @Builtin(doc = "Stands behind the slot of that name of an object.", needs = Permission.CHANGE)
  void init(Frame frame, UrbiUVar self, UrbiObject owner, String name) {
    bind(frame, "init", self, owner, name);
  }

  @Builtin(doc = "Stands behind a slot of another object, too.", needs = Permission.USER)
  void copy(Frame frame, UrbiUVar self, UrbiObject targetObject, String targetName) {
    bind(frame, "copy", self, targetObject, targetName);
  }

  private void bind(Frame frame, String routine, UrbiUVar self, UrbiObject owner, String name) {
    PermissionCheck.checkChange(frame, routine, owner);
    Symbol slot = self.world().symbol(name);
    UrbiObject hooked = self.lookup(self.world().symbol("hookChanged"));
    self.bind(
        frame.interpreter(),
        owner,
        slot,
        uobjects.nameOf(frame, owner),
        hooked == null || Truth.of(frame, hooked));
  }

  /** Refuses to write a variable that stands behind a slot which the caller may not change. */
  static void checkWrite(Frame frame, String routine, UrbiUVar variable) {
    PermissionCheck.checkChange(frame, routine, variable);
    UrbiObject owner = variable.owner();
    if (owner != null) {
      PermissionCheck.checkChange(frame, routine, owner);
    }
  }

  @Builtin(doc = "The object behind whose slot it stands; nil when that has gone.")
  static UrbiObject owner(Frame frame, UrbiUVar self) {
    UrbiObject owner = self.owner();
    return owner == null ? frame.interpreter().values().nil : owner;
  }

  @Builtin(doc = "The name under which it was made: that of the object, a period, the slot.")
  static String initialName(UrbiUVar self) {
    return self.name();
  }

  @Builtin(doc = "The name of the object under which it was made.")
  static String ownerName(UrbiUVar self) {
    return self.name().replaceFirst("\\.[^.]*$", "");
  }

  // ------------------------------------------------------------------ hooks

  /**
   * Everybody may hook a variable, but not the prototype: that has no value of which somebody would
   * have to know, and what is hooked there stays until an owner removes it.
   */
  private static void checkHook(Frame frame, String routine, UrbiUVar hooked) {
    if (hooked == hooked.world().prototype("UVar")) {
      PermissionCheck.checkChange(frame, routine, hooked);
    }
  }

  @Builtin(doc = "Calls a function at each change; returns a handle to remove it.")
  static double notifyChange(Frame frame, UrbiUVar self, UrbiObject onChange) {
    checkHook(frame, "notifyChange", self);
    return self.notifyChange(frame.interpreter(), Hook.calling(frame, onChange));
  }

  @Builtin(doc = "As notifyChange, for commands to a variable that has a sensed value as well.")
  static double notifyChangeOwned(Frame frame, UrbiUVar self, UrbiObject onChangeOwned) {
    checkHook(frame, "notifyChangeOwned", self);
    return self.notifyChangeOwned(Hook.calling(frame, onChangeOwned));
  }

  @Builtin(doc = "Calls a function at each access; returns a handle to remove it.")
  static double notifyAccess(Frame frame, UrbiUVar self, UrbiObject onAccess) {
    checkHook(frame, "notifyAccess", self);
    return self.notifyAccess(frame, Hook.calling(frame, onAccess));
  }

  @Builtin(doc = "Removes a function that notifyChange has installed.", needs = Permission.CHANGE)
  static boolean removeNotifyChange(UrbiUVar self, double id) {
    return self.removeChange((long) id);
  }

  @Builtin(
      doc = "Removes a function that notifyChangeOwned has installed.",
      needs = Permission.CHANGE)
  static boolean removeNotifyChangeOwned(UrbiUVar self, double id) {
    return self.removeChangeOwned((long) id);
  }

  @Builtin(doc = "Removes a function that notifyAccess has installed.", needs = Permission.CHANGE)
  static boolean removeNotifyAccess(UrbiUVar self, double id) {
    return self.removeAccess((long) id);
  }

  @Builtin(doc = "The event that is emitted with each new value.")
  static UrbiObject changed(Frame frame, UrbiUVar self) {
    return self.changed(frame.interpreter());
  }

  // ------------------------------------------------------------------ values

  @Builtin(doc = "Whether it has both a sensed and a commanded value.")
  static boolean owned(UrbiUVar self) {
    return self.isOwned();
  }

  @Builtin(
      value = "owned",
      setter = true,
      doc = "Gives it both a sensed and a commanded value.",
      needs = Permission.CHANGE)
  static void assignOwned(Frame frame, UrbiUVar self, UrbiObject on) {
    if (Truth.of(frame, on)) {
      self.own();
    }
  }

  @Builtin(
      doc =
          "Whether its values travel in datagrams to and from remote UObjects, if urbi/rtp is"
              + " loaded; nil for binaries only.")
  static UrbiObject rtp(Frame frame, UrbiUVar self) {
    Boolean on = self.rtp();
    Values values = frame.interpreter().values();
    return on == null ? values.nil : values.bool(on);
  }

  @Builtin(
      value = "rtp",
      setter = true,
      doc = "Says whether its values travel in datagrams; UVar.rtp, whether those of all do.",
      needs = Permission.CHANGE)
  static void assignRtp(Frame frame, UrbiUVar self, UrbiObject on) {
    self.setRtp(on == frame.interpreter().values().nil ? null : (Boolean) Truth.of(frame, on));
  }

  @Builtin(
      value = {"val", "value"},
      doc = "The value; if it has two, the commanded one. No function is called for it.")
  static UrbiObject val(Frame frame, UrbiUVar self) {
    return TakenCode.by(frame, self.target().value());
  }

  @Builtin(
      value = {"val", "value"},
      setter = true,
      doc = "Sets the value; if it has two, the commanded one.",
      needs = Permission.CHANGE)
  static void assignVal(Frame frame, UrbiUVar self, UrbiObject value) {
    checkWrite(frame, "val", self);
    self.write(frame, new Datum(TakenCode.by(frame, value)));
  }

  @Builtin(
      doc = "Reads the value as the slot does, which may call functions. The list is not used.")
  static UrbiObject apply(Frame frame, UrbiUVar self, UrbiObject arguments) {
    return TakenCode.by(frame, self.read(frame));
  }

  @Builtin(doc = "When the value was last written, in seconds as those of System.time.")
  static double timestamp(UrbiUVar self) {
    return Math.max(0, self.writes().last()) / NANOSECONDS_PER_SECOND;
  }

  @Builtin(doc = "The value that everybody reads. No function is called for it.")
  static UrbiObject valsensor(Frame frame, UrbiUVar self) {
    return TakenCode.by(frame, self.visible().value());
  }

  @Builtin(
      value = "valsensor",
      setter = true,
      doc = "Sets the value that everybody reads.",
      needs = Permission.CHANGE)
  static void assignValsensor(Frame frame, UrbiUVar self, UrbiObject value) {
    checkWrite(frame, "valsensor", self);
    self.set(frame, new Datum(TakenCode.by(frame, value)));
  }

  @Builtin(
      doc =
          "A process that is linked with the SDK of Urbi 2.7 sets the value; the time is its own"
              + " affair.",
      needs = Permission.CHANGE)
  void update_timed(Frame frame, UrbiUVar self, UrbiObject value, double microseconds) {
    checkWrite(frame, "update_timed", self);
    UrbiObject taken = TakenCode.by(frame, value);
    Runnable writing = () -> self.write(frame, new Datum(taken));
    if (LobbyType.of(frame).remoteObjects() instanceof ExternalProcess process) {
      process.variables().set(self, writing);
    } else {
      writing.run();
    }
  }

  // ------------------------------------------------------------------ connections

  @Builtin(
      value = ">>",
      doc = "Leads each new value to another variable: a UConnection.",
      needs = Permission.USER)
  static UrbiObject lead(Frame frame, UrbiUVar self, UrbiUVar target) {
    UrbiObject prototype = frame.interpreter().world().prototype("UConnection");
    return frame.interpreter().send(frame, prototype, "new", self, target);
  }

  @Builtin(
      value = "<<",
      doc = "Leads each new value of another variable here: a UConnection.",
      needs = Permission.CHANGE)
  static UrbiObject take(Frame frame, UrbiUVar self, UrbiUVar source) {
    return lead(frame, source, self);
  }

  @Builtin(doc = "The connections that begin here.")
  static List<UrbiConnection> changeConnections(UrbiUVar self) {
    return self.connections();
  }
}
