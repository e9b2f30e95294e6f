package org.urbi.kernel.node;

import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.budget.Budget;
import org.urbi.kernel.budget.Resource;
import org.urbi.kernel.error.Errors;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.Scheduler;
import org.urbi.kernel.object.Elements;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.Values;
import org.urbi.kernel.object.World;
import org.urbi.lang.source.Span;

/**
 * The environment of executing code: the objects of the kernel, its scheduler, its errors; and the
 * methods by which Java code calls urbiscript.
 */
public final class Interpreter {
  /** A call made by Java code: it does not show in backtraces. */
  private record JavaCallSite(String calledName, boolean isNamed) implements CallSite {
    @Override
    public @Nullable Span calledSpan() {
      return null;
    }

    @Override
    public boolean isTraced() {
      return false;
    }
  }

  /** How deeply calls from Java may be nested: data nested more deeply must contain itself. */
  private static final int MAXIMUM_NESTED_SENDS = 10_000;

  private static final CallSite FROM_JAVA = new JavaCallSite("apply", false);
  private static final CallSite EQUALITY_FROM_JAVA = new JavaCallSite("==", true);

  private final World world;
  private final Values values;
  private final Scheduler scheduler;
  private final Errors errors;
  private final CoreSymbols symbols;
  private final CallMessages callMessages;
  private final Map<Symbol, UrbiObject> numberOperators = new LinkedHashMap<>();
  private @Nullable UrbiObject equalityOfNumbers;
  private @Nullable UrbiObject equalityOfStrings;
  private @Nullable UrbiObject differenceOfStrings;
  private @Nullable UrbiObject identity;
  private @Nullable UrbiObject difference;
  private final Map<UrbiObject, Shortcut> shortcuts = new IdentityHashMap<>();
  final CorePrototypes prototypes;
  private BiConsumer<Frame, UrbiException> describer = (frame, exception) -> {};
  private Consumer<Frame> afterStatements = frame -> {};
  private CodeCompiler compiler = CodeCompiler.NONE;
  private boolean assertionsDisabled;
  private boolean assertionsShowValues = true;
  boolean profiling;
  private int comparedEpoch = -1;
  private int maximumDepth;

  /**
   * The depth up to which a call needs no check: the lowest limit, or -1 while some code must be
   * interrupted. So endless recursion can be interrupted at no extra cost.
   */
  private volatile int callLimit;

  /** The lowest limit of nested calls that the budget of a lobby has had. */
  private volatile long lowestDepth = Budget.UNLIMITED;

  public Interpreter(World world, Scheduler scheduler, Errors errors, CorePrototypes prototypes) {
    this.world = world;
    this.values = world.values();
    this.scheduler = scheduler;
    this.errors = errors;
    this.symbols = new CoreSymbols(world);
    this.callMessages = new CallMessages(world);
    this.prototypes = prototypes;
    this.maximumDepth = scheduler.maximumDepth();
    scheduler.setRefusals(errors::scheduling);
    scheduler.interruptions().whenChanged(this::setCallLimit);
    world.setCheckpoint(this::checkInterrupted);
  }

  public World world() {
    return world;
  }

  public Values values() {
    return values;
  }

  public Scheduler scheduler() {
    return scheduler;
  }

  public Errors errors() {
    return errors;
  }

  /** The names that the interpreter itself looks up. */
  public CoreSymbols symbols() {
    return symbols;
  }

  /** Makes call messages, and reads them. */
  public CallMessages callMessages() {
    return callMessages;
  }

  /** The prototypes of objects that the interpreter creates, other than everyday values. */
  public CorePrototypes prototypes() {
    return prototypes;
  }

  /** Compiles code that runs often. */
  public CodeCompiler compiler() {
    return compiler;
  }

  /** Sets that; once, by the kernel. */
  public void setCompiler(CodeCompiler other) {
    compiler = other;
  }

  /** Limits the number of nested calls. */
  public void limitDepth(int calls) {
    maximumDepth = Math.min(calls, scheduler.maximumDepth());
    setCallLimit();
  }

  /** The budget of a lobby limits the number of nested calls. */
  public void budgetDepth(long calls) {
    lowestDepth = Math.min(calls, lowestDepth);
    setCallLimit();
  }

  /** Synchronized because several threads call it: the last one must see the changes of all. */
  private synchronized void setCallLimit() {
    callLimit =
        scheduler.interruptions().arePending()
            ? -1
            : (int) Math.min(Math.min(maximumDepth, Job.DEEP), lowestDepth);
  }

  /** The checks at the start of each function call. */
  void enter(Job job, int depth) {
    if (depth > callLimit) {
      job.checkInterrupted();
      if (depth > maximumDepth || !job.budget().allows(Resource.DEPTH, depth)) {
        throw errors.scheduling(Problem.STACK_EXHAUSTED);
      }
      job.noteCalls(depth);
    }
  }

  /** Throws if somebody has asked to end the running job. */
  public void checkInterrupted() {
    Job job = scheduler.running();
    if (job != null) {
      job.checkInterrupted();
    }
  }

  /** The same for long work in Java: {@link Job#worked}. */
  public void worked(long more) {
    Job job = scheduler.running();
    if (job != null) {
      job.worked(more);
    }
  }

  /** How many nested calls there may be. */
  public int maximumDepth() {
    return maximumDepth;
  }

  /** Whether calls must be counted, because some job is or was profiled. */
  public boolean isProfiling() {
    return profiling;
  }

  /** From now on every call is reported to the profiler of its job, if there is one. */
  void startProfiling() {
    profiling = true;
    world.profiled = true;
    // Invalidates all cached lookups of operators.
    values.floatProto.setProtos(values.floatProto.protos());
  }

  /** The operator of plain numbers of that name, as the library made it; null if none. */
  @Nullable UrbiObject operatorOfNumbers(Symbol name) {
    return numberOperators.get(name);
  }

  /** Remembers operators of the library, to know later whether somebody redefined one. */
  public void rememberOperators() {
    for (String operator :
        List.of("+", "-", "*", "/", "%", "**", "<", "<=", ">", ">=", "==", "!=")) {
      Symbol name = world.symbol(operator);
      numberOperators.put(name, values.floatProto.lookup(name));
    }
    shorten(values.listProto, "[]", Shortcut.ELEMENT);
    shorten(values.listProto, "[]=", Shortcut.SET_ELEMENT);
    shorten(values.listProto, "<<", Shortcut.APPEND);
    shorten(values.listProto, "size", Shortcut.SIZE_OF_LIST);
    shorten(values.stringProto, "size", Shortcut.SIZE_OF_TEXT);
    shorten(values.dictionaryProto, "size", Shortcut.SIZE_OF_DICTIONARY);
    shorten(values.booleanProto, "!", Shortcut.NOT);
    shorten(values.dictionaryProto, "[]", Shortcut.ENTRY);
    shorten(values.dictionaryProto, "[]=", Shortcut.SET_ENTRY);
    shorten(values.dictionaryProto, "has", Shortcut.HAS_ENTRY);
    identity = values.object.lookup(symbols.equals);
    difference = values.nil.lookup(world.symbol("!="));
    differenceOfStrings = values.stringProto.lookup(world.symbol("!="));
    equalityOfNumbers = values.floatProto.lookup(symbols.equals);
    equalityOfStrings = values.stringProto.lookup(symbols.equals);
  }

  private void shorten(UrbiObject proto, String name, Shortcut how) {
    UrbiObject code = proto.lookup(world.symbol(name));
    if (code != null) {
      shortcuts.put(code, how);
    }
  }

  /** The shortcut for a function of the library; null if there is none. */
  public @Nullable Shortcut shortcut(UrbiObject code) {
    return shortcuts.get(code);
  }

  /**
   * Whether {@code ==} or {@code !=} of an object only asks whether it is the same object.
   *
   * @param found the operator
   * @param equality {@code ==} of that object
   */
  boolean comparesIdentity(UrbiObject found, @Nullable UrbiObject equality) {
    return found == identity || found == difference && equality == identity;
  }

  /** Whether that is {@code ==} or {@code !=} of strings. */
  boolean comparesText(UrbiObject found) {
    return found == equalityOfStrings || found == differenceOfStrings;
  }

  // ------------------------------------------------------------------ calling urbiscript

  private static CallSite javaSite(String name) {
    return new JavaCallSite(name, true);
  }

  /** Calls a function; any other value is returned as it is. */
  public UrbiObject call(Frame caller, UrbiObject code, UrbiObject self, UrbiObject... arguments) {
    CallSite site =
        code instanceof Code own && own.name() != null ? javaSite(own.name()) : FROM_JAVA;
    return call(caller, site, code, self, arguments);
  }

  /** Calls a function on behalf of a library function called at that site. */
  public UrbiObject call(
      Frame caller, CallSite site, UrbiObject code, UrbiObject self, UrbiObject... arguments) {
    // The library calls in loops, and only functions in urbiscript check themselves.
    caller.job.checkInterrupted();
    if (code instanceof Code called) {
      CallSite from = called.isLazy() ? new EvaluatedCallSite(site, arguments) : site;
      return called.call(caller, from, self, arguments);
    }
    UrbiObject apply = code.lookup(symbols.apply);
    if (apply instanceof Code own && code.locate(symbols.apply) != values.object) {
      var all = new Elements(1 + arguments.length);
      all.add(self);
      all.addAll(Arrays.asList(arguments));
      return own.call(caller, site, code, values.listOf(all));
    }
    if (arguments.length > 0) {
      if (code.lookup(symbols.parentheses) instanceof Code own) {
        return call(caller, site, own, code, arguments);
      }
      throw errors.arity(site.calledName(), arguments.length, 0, 0);
    }
    return code;
  }

  /**
   * Sends a message. Endless recursion through this method, such as comparing two lists that
   * contain themselves, throws the error of an exhausted stack.
   */
  public UrbiObject send(Frame caller, UrbiObject target, String message, UrbiObject... arguments) {
    beginSend(caller);
    try {
      return send(caller, javaSite(message), target, world.symbol(message), arguments);
    } finally {
      caller.job.endSend();
    }
  }

  /** Sends a message whose slot is always looked for at the same place of the code. */
  UrbiObject send(Frame caller, UrbiObject target, SlotLookup lookup, UrbiObject... arguments) {
    beginSend(caller);
    try {
      Symbol name = lookup.name();
      UrbiObject found = lookup.find(caller, target);
      return answer(caller, javaSite(name.name()), target, name, found, arguments);
    } finally {
      caller.job.endSend();
    }
  }

  private void beginSend(Frame caller) {
    caller.job.checkInterrupted();
    if (!caller.job.beginSend(Math.min(MAXIMUM_NESTED_SENDS, maximumDepth))) {
      throw errors.scheduling(Problem.STACK_EXHAUSTED);
    }
  }

  /**
   * Whether a value is equal to an expected one, by the {@code ==} of the latter. That of numbers
   * and that of strings are computed here, unless somebody has redefined them.
   *
   * @param equality where that has been found before
   */
  boolean isEqual(Frame caller, SlotLookup equality, UrbiObject expected, UrbiObject value) {
    UrbiObject found = equality.find(caller, expected);
    if (found != null && !world.profiled) {
      if (expected instanceof UrbiFloat number && found == equalityOfNumbers) {
        return value instanceof UrbiFloat other && number.value() == other.value();
      }
      if (expected instanceof UrbiString text && found == equalityOfStrings) {
        return value instanceof UrbiString other && text.value().equals(other.value());
      }
    }
    UrbiObject answer;
    beginSend(caller);
    try {
      answer = answer(caller, EQUALITY_FROM_JAVA, expected, symbols.equals, found, value);
    } finally {
      caller.job.endSend();
    }
    return Truth.of(caller, answer);
  }

  /** Whether literal numbers and strings are compared by the {@code ==} of the library. */
  boolean comparesLiterals() {
    int epoch = symbols.equals.epoch();
    if (epoch != comparedEpoch) {
      if (world.profiled
          || values.floatProto.lookup(symbols.equals) != equalityOfNumbers
          || values.stringProto.lookup(symbols.equals) != equalityOfStrings) {
        return false;
      }
      comparedEpoch = world.remember(symbols.equals);
    }
    return true;
  }

  /** Sends a message on behalf of a library function called at that site. */
  public UrbiObject send(
      Frame caller, CallSite site, UrbiObject target, Symbol message, UrbiObject... arguments) {
    UrbiObject found = SlotLookup.find(caller, target, message);
    return answer(caller, site, target, message, found, arguments);
  }

  /** The same for what may send it on, even to itself: that may be nested only so deeply. */
  public UrbiObject sendOn(
      Frame caller, CallSite site, UrbiObject target, Symbol message, UrbiObject... arguments) {
    beginSend(caller);
    try {
      return send(caller, site, target, message, arguments);
    } finally {
      caller.job.endSend();
    }
  }

  /**
   * What a message is answered with.
   *
   * @param found the slot of that name, or null
   */
  private UrbiObject answer(
      Frame caller,
      CallSite site,
      UrbiObject target,
      Symbol message,
      @Nullable UrbiObject found,
      UrbiObject... arguments) {
    if (found == null) {
      return fallback(
          caller, new EvaluatedCallSite(javaSite(message.name()), arguments), target, message);
    }
    if (found instanceof Code) {
      return call(caller, site, found, target, arguments);
    }
    if (arguments.length > 0) {
      throw errors.arity(message.name(), arguments.length, 0, 0);
    }
    return found;
  }

  /**
   * Sends a message for which the target has no slot: its {@code fallback} answers, if it has one.
   *
   * @param site has the name and the arguments of the message
   */
  public UrbiObject fallback(Frame caller, CallSite site, UrbiObject target, Symbol message) {
    return Calls.fallback(caller, site, target, message, site.argumentNodes());
  }

  /** The value of a slot, not called if it is a function. */
  public UrbiObject get(Frame caller, UrbiObject target, Symbol name) {
    UrbiObject value = SlotLookup.find(caller, target, name);
    if (value == null) {
      throw errors.lookup(target, name.name());
    }
    return value;
  }

  /** The stored value of a slot: neither called, nor computed by a getter. */
  public UrbiObject getRaw(UrbiObject target, Symbol name) {
    UrbiObject value = SlotLookup.findRaw(target, name);
    if (value == null) {
      throw errors.lookup(target, name.name());
    }
    return value;
  }

  /** The stored value of a slot, as {@link #getRaw}; null if there is no such slot. */
  public @Nullable UrbiObject findRaw(UrbiObject target, Symbol name) {
    return SlotLookup.findRaw(target, name);
  }

  /** The value as a string of urbiscript, by its {@code asString}. */
  public String asString(Frame caller, UrbiObject value) {
    return text(caller, value, symbols.asString);
  }

  /** The value as the console shows it, by its {@code asPrintable}. */
  public String asPrintable(Frame caller, UrbiObject value) {
    return text(caller, value, symbols.asPrintable);
  }

  private String text(Frame caller, UrbiObject value, Symbol how) {
    if (value instanceof UrbiString string && how == symbols.asString) {
      return string.value();
    }
    UrbiObject text = send(caller, javaSite(how.name()), value, how);
    if (text instanceof UrbiString string) {
      return string.value();
    }
    throw errors.argumentType(how.name(), 0, text, values.stringProto);
  }

  /** Whether {@code assert} checks nothing ({@code System.ndebug}). */
  public boolean assertionsDisabled() {
    return assertionsDisabled;
  }

  public void disableAssertions(boolean disabled) {
    assertionsDisabled = disabled;
  }

  /** Whether the message of a failed assertion shows the values of its parts. */
  public boolean assertionsShowValues() {
    return assertionsShowValues;
  }

  public void showValuesOfAssertions(boolean shown) {
    assertionsShowValues = shown;
  }

  /** Gives a caught exception its {@code location}, {@code backtrace} and {@code message}. */
  void describe(Frame frame, UrbiException exception) {
    describer.accept(frame, exception);
  }

  /** Sets what {@link #describe} does; once, by the library. */
  public void setDescriber(BiConsumer<Frame, UrbiException> how) {
    describer = how;
  }

  /** Runs the actions that follow each statement of the top level. */
  public void statementOver(Frame frame) {
    afterStatements.accept(frame);
  }

  /** Sets what {@link #statementOver} does; once, by the library. */
  public void setAfterStatements(Consumer<Frame> action) {
    afterStatements = action;
  }

  /** Reports an error that no code will catch to the client of the job's lobby. */
  public void report(Job job, Throwable failure) {
    scheduler.report(job, failure);
  }

  /** Checks that a value may be passed on. */
  UrbiObject notVoid(UrbiObject value) {
    if (value == values.voidObject) {
      throw errors.unexpectedVoid();
    }
    return value;
  }

  /** Adds to an exception where it was thrown, if that is not known yet. */
  static UrbiException located(UrbiException exception, Frame frame, Span span) {
    return frame.located(exception, span);
  }
}
