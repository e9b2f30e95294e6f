package org.urbi.kernel.library;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.urbi.kernel.builtin.BuiltinTable;
import org.urbi.kernel.builtin.Primitive;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.library.code.ScriptCode;
import org.urbi.kernel.library.code.StackFrames;
import org.urbi.kernel.library.concurrent.EventType;
import org.urbi.kernel.library.exception.ExceptionTypes;
import org.urbi.kernel.library.math.FloatType;
import org.urbi.kernel.library.motion.TrajectoryKinds;
import org.urbi.kernel.library.motion.TrajectorySequence;
import org.urbi.kernel.library.motion.TrajectoryUntil;
import org.urbi.kernel.library.object.UrbiFinalizable;
import org.urbi.kernel.library.system.EvaluateVariable;
import org.urbi.kernel.library.value.OwnSlots;
import org.urbi.kernel.node.ClassNodes;
import org.urbi.kernel.node.CorePrototypes;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.node.PermissionCheck;
import org.urbi.kernel.object.SlotData;
import org.urbi.kernel.object.SlotNames;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;
import org.urbi.kernel.object.World;
import org.urbi.lang.source.Span;

/** Fills a fresh kernel with the standard library, from the tables of builtins. */
public final class Library {
  private final Interpreter interpreter;
  private final StackFrames stackFrames;
  private final World world;
  private final Values values;
  private final Map<String, UrbiObject> types = new LinkedHashMap<>();

  /** What a caught exception has, if it is known where it was thrown, and if that has a place. */
  private final SlotNames located;

  private final SlotNames placed;
  private final Symbol message;

  private Library(Interpreter interpreter, StackFrames stackFrames) {
    this.stackFrames = stackFrames;
    this.interpreter = interpreter;
    this.world = interpreter.world();
    this.values = interpreter.values();
    this.located = new SlotNames(world.symbol("backtrace"));
    this.placed = new SlotNames(world.symbol("location"), world.symbol("backtrace"));
    this.message = world.symbol("message");
  }

  /**
   * Installs the library.
   *
   * @param tables the tables of {@link LibraryTables}
   * @param stackFrames shows the backtraces of exceptions
   */
  public static void install(
      Interpreter interpreter, BuiltinTable[] tables, StackFrames stackFrames) {
    new Library(interpreter, stackFrames).install(withTables(tables));
  }

  /**
   * The tables of the library, only for reading: builtins that need services of the kernel cannot
   * be called.
   */
  public static List<BuiltinTable> declarations() {
    return withTables(LibraryTables.declarations());
  }

  /** All tables in alphabetical order; the parts of a type follow the one that declares it. */
  private static List<BuiltinTable> withTables(BuiltinTable[] generated) {
    List<BuiltinTable> all = new ArrayList<>(List.of(generated));
    all.addAll(ExceptionTypes.tables());
    all.addAll(TrajectoryKinds.tables());
    // One that Comparator makes is in no start-up cache.
    all.sort((a, b) -> a.type().compareTo(b.type()));
    return all;
  }

  private void install(List<BuiltinTable> tables) {
    known();
    for (BuiltinTable table : tables) {
      if (!table.isPart()) {
        types.computeIfAbsent(table.type(), type -> prototype(table));
      }
    }
    types.forEach(world::declarePrototype);
    for (BuiltinTable table : tables) {
      UrbiObject type = type(table.type());
      if (!table.isPart()) {
        name(table, type);
      }
      addBuiltins(table, type);
    }
    inheritance(tables);
    constants();
    EvaluateVariable.install(interpreter);
    interpreter.setDescriber(this::describe);
    interpreter.setAfterStatements(((UrbiFinalizable) type("Finalizable")).finalization()::run);
    interpreter.rememberOperators();
    keep();
  }

  /** All this belongs to the system: the prototypes, and what their slots hold. */
  private void keep() {
    types.values().forEach(PermissionCheck::claimForSystem);
  }

  /** The prototypes that exist before the library does. */
  private void known() {
    CorePrototypes core = interpreter.prototypes();
    types.put("Object", values.object);
    types.put("Float", values.floatProto);
    types.put("String", values.stringProto);
    types.put("List", values.listProto);
    types.put("Tuple", values.tupleProto);
    types.put("Dictionary", values.dictionaryProto);
    types.put("Boolean", values.booleanProto);
    types.put("nil", values.nil);
    types.put("void", values.voidObject);
    types.put("Executable", core.executable);
    types.put("Code", core.code);
    types.put("Primitive", core.primitive);
    types.put("Lazy", core.lazy);
    types.put("CallMessage", core.callMessage);
    types.put("Enumeration", core.enumeration);
    types.put("Event", core.event);
    types.put("Tag", core.tag);
    types.put("Tag.tags", core.tags);
  }

  private UrbiObject type(String name) {
    return requireNonNull(types.get(name), "every type has been made before");
  }

  private UrbiObject prototype(BuiltinTable table) {
    UrbiObject made = table.newPrototype(world);
    return made == null ? values.object.cloned() : made;
  }

  private UrbiObject primitive(BuiltinTable table, int index) {
    return new Primitive(interpreter.prototypes().primitiveShape(), table, index);
  }

  /** Makes the type known by its name, in Global or in the type whose part it is. */
  private void name(BuiltinTable table, UrbiObject type) {
    String full = table.type();
    int dot = full.lastIndexOf('.');
    String simple = full.substring(dot + 1);
    UrbiObject owner = dot < 0 ? type("Global") : type(full.substring(0, dot));
    owner.addSlot(world.symbol(simple), type);
    ClassNodes.nameType(interpreter, type, simple);
    if (full.equals("Exception") || full.startsWith("Exception.")) {
      type.addSlot(world.symbol("fullType"), values.string(full));
    }
  }

  private void addBuiltins(BuiltinTable table, UrbiObject type) {
    List<Symbol> names = new ArrayList<>();
    List<UrbiObject> primitives = new ArrayList<>();
    for (int i = 0; i < table.size(); i++) {
      if (!table.isSetter(i)) {
        Symbol name = world.symbol(table.name(i));
        type.removeSlot(name);
        names.add(name);
        primitives.add(primitive(table, i));
      }
    }
    type.addSlots(names.toArray(Symbol[]::new), primitives.toArray(UrbiObject[]::new));
    for (int i = 0; i < table.size(); i++) {
      if (table.isSetter(i)) {
        Symbol name = world.symbol(table.name(i));
        SlotData data = type.ensureSlotData(name);
        data.setSetter(primitive(table, i));
        type.slotDataChanged(name);
      }
    }
  }

  private void inheritance(List<BuiltinTable> tables) {
    for (BuiltinTable table : tables) {
      if (!table.isPart()) {
        List<UrbiObject> protos = new ArrayList<>();
        for (String proto : table.protos()) {
          UrbiObject found = types.get(proto);
          if (found != null) {
            protos.add(found);
          }
        }
        type(table.type()).setProtos(protos.toArray(UrbiObject[]::new));
      }
    }
  }

  private void constants() {
    UrbiObject global = type("Global");
    global.addSlot(world.symbol("true"), values.trueObject);
    global.addSlot(world.symbol("false"), values.falseObject);
    // What a later program puts into its package of the language everybody has.
    type("package").addSlot(world.symbol("lang"), global);
    UrbiObject channel = type("Channel");
    channel.addSlot(world.symbol("name"), values.string(""));
    channel.addSlot(world.symbol("enabled"), values.trueObject);
    channel.addSlot(world.symbol("quote"), values.trueObject);
    UrbiObject topLevel = channel(channel, "", true);
    channel.addSlot(world.symbol("topLevel"), topLevel);
    UrbiObject none = channel(channel, "", true);
    none.addSlot(world.symbol("enabled"), values.falseObject);
    channel.addSlot(world.symbol("null"), none);
    global.addSlot(world.symbol("cerr"), channel(channel, "error", false));
    global.addSlot(world.symbol("clog"), channel(channel, "clog", true));
    global.addSlot(world.symbol("cout"), channel(channel, "output", true));
    script(values.stringProto, "asList", "function () { split(\"\") }");
    script(type("TrajectoryGenerator.Until"), "run", TrajectoryUntil.RUN);
    script(type("TrajectoryGenerator.Sequence"), "run", TrajectorySequence.RUN);
    // Void has no prototype; a void that was accepted is an object like others.
    values.acceptedVoid.setProtos(values.voidObject, type("Singleton"));
    LegacyNames.add(interpreter, types);
    EventType.fill(type("Event"));
    for (String name : List.of("detach", "disown", "persist", "waituntil")) {
      global.addSlot(world.symbol(name), type("Control").existingSlot(world.symbol(name)));
    }
    UrbiObject lobby = type("Lobby");
    lobby.setProtos(topLevel);
    lobby.addSlot(world.symbol("topLevel"), topLevel);
    lobby.addSlot(world.symbol("onDisconnect"), interpreter.prototypes().event.cloned());
    channel.addSlot(world.symbol("warning"), channel(channel, "warning", false));
    type("Float").addSlot(world.symbol("epsilonTilde"), values.number(FloatType.TOLERANCE));
    type("System").addSlot(world.symbol("period"), values.number(0.02));
    type("Exception.Lookup").addSlot(world.symbol("fixSpelling"), values.trueObject);
    type("UVar").addSlot(world.symbol("hookChanged"), values.trueObject);
    type("UVar").addSlot(world.symbol("eraseThrowingCallbacks"), values.falseObject);
    type("Exception").addSlot(world.symbol("message"), values.string("<no message>"));
  }

  /** Gives a type a function written in urbiscript. */
  private void script(UrbiObject type, String name, String function) {
    Symbol slot = world.symbol(name);
    type.removeSlot(slot);
    type.addSlot(slot, new ScriptCode(interpreter.prototypes().code.cloneShape(), function));
  }

  private UrbiObject channel(UrbiObject prototype, String name, boolean quote) {
    UrbiObject channel = prototype.cloned();
    channel.addSlot(world.symbol("name"), values.string(name));
    if (!quote) {
      channel.addSlot(world.symbol("quote"), values.falseObject);
    }
    return channel;
  }

  /** Gives a caught exception the place where it was thrown, and its message. */
  private void describe(Frame frame, UrbiException exception) {
    UrbiObject value = exception.value();
    if (!value.isA(type("Exception"))) {
      return;
    }
    addMessage(frame, value);
    if (exception.isLocated()) {
      UrbiObject calls = stackFrames.list(exception.backtrace());
      Span span = exception.span();
      if (span == null) {
        located.put(value, calls);
      } else {
        placed.put(value, stackFrames.locations().location(span), calls);
      }
    }
  }

  /** An exception of the library that shows values has no message before it is caught. */
  private void addMessage(Frame frame, UrbiObject value) {
    if (value.localSlot(message) != null) {
      return;
    }
    boolean argument = value.isA(type("Exception.Argument"));
    if (argument || value.isA(type("Exception.Type")) || value.isA(type("Exception.BadNumber"))) {
      if (argument && value.localSlot(world.symbol("exception")) instanceof UrbiObject cause) {
        addMessage(frame, cause);
      }
      try {
        String text = interpreter.asString(frame, value);
        OwnSlots.put(value, "message", values.string(text));
      } catch (UrbiException e) {
        // A value that cannot be shown: the exception is the one that was thrown all the same.
      }
    }
  }
}
