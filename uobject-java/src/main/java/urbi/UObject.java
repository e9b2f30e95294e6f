package urbi;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jspecify.annotations.Nullable;

/**
 * The Java side of an urbiscript object (manual, "The UObject Java API"). A subclass has a
 * constructor that takes its name, is declared by {@link #UStart}, and binds what urbiscript may
 * see of it: variables, functions, events.
 *
 * <p>One that implements {@link AutoCloseable} is closed when its urbiscript object has gone.
 */
// An object is known to its context while it is being constructed: that is how it can bind. A
// lambda
// given to bind() either returns something or does not, which tells the overloads apart.
@SuppressWarnings({"this-escape", "overloads"})
public abstract non-sealed class UObject extends UObjectBase {
  private final String name;
  private final UClass type;
  private final UTaskQueue queue = new UTaskQueue();
  private final Map<String, UTaskQueue> queues = new ConcurrentHashMap<>();
  private final Map<String, UVar> variables = new ConcurrentHashMap<>();
  private final List<Runnable> notifications = new CopyOnWriteArrayList<>();
  private final List<UObjectHub> hubs = new CopyOnWriteArrayList<>();
  private final boolean derived;
  private final AtomicBoolean cleaned = new AtomicBoolean();

  /**
   * An object that urbiscript or the kernel makes.
   *
   * @param name as it is given to the constructor of the subclass
   */
  protected UObject(String name) {
    super(UContext.current());
    this.type = UClass.of(getClass(), name);
    this.name = getUContext().attach(this, name);
    this.derived = !this.name.equals(type.name());
  }

  /** An object that Java code makes by itself; urbiscript gets one as well. */
  protected UObject() {
    super(UContext.current());
    this.type = UClass.of(getClass(), null);
    this.name = getUContext().attach(this, null);
    this.derived = true;
  }

  // ------------------------------------------------------------------ declaration

  /** Declares a class, under its simple name (manual, "Creating a class"). */
  public static void UStart(Class<? extends UObject> javaClass) {
    UStartRename(javaClass, UModule.simpleName(javaClass));
  }

  /** Declares a class under another name. */
  public static void UStartRename(Class<? extends UObject> javaClass, String urbiName) {
    UModule module = UModule.of(javaClass.getClassLoader());
    module.add(module.typeOf(javaClass, urbiName));
  }

  /** Declares a class of hubs, of which there is one instance in each context. */
  public static void UStartHub(Class<? extends UObjectHub> javaClass) {
    UModule module = UModule.of(javaClass.getClassLoader());
    module.add(
        new UHubClass(
            UModule.simpleName(javaClass),
            module,
            Constructors.of(javaClass, UObjectHub.class)::newInstance));
  }

  /**
   * Runs the classes that the program has declared, connected to a server: for programs with a main
   * of their own (manual, "Providing a main class or not"). The arguments are those of {@link
   * UMain}; it returns when the connection ends.
   *
   * @throws IllegalStateException if that did not go well; the message has been printed
   */
  public static void main(String[] arguments) {
    Class<?> caller =
        StackWalker.getInstance(StackWalker.Option.RETAIN_CLASS_REFERENCE).getCallerClass();
    UModule program = UModule.of(caller.getClassLoader());
    if (RemoteRunner.get().run(arguments, program, System.out, System.err) != 0) {
      throw new IllegalStateException("the UObjects could not be run");
    }
  }

  // ------------------------------------------------------------------ what it is

  /** Its name in urbiscript, a slot of {@code uobjects}. */
  public final String get__name() {
    return name;
  }

  @Override
  final String shownName() {
    return name;
  }

  /** The class as it was declared. */
  public final UClass getUClass() {
    return type;
  }

  /** The name of its class in urbiscript. */
  public String getClassname() {
    return type.name();
  }

  /** Whether urbiscript has made it by {@code new}: false for the first one, the prototype. */
  public boolean getDerived() {
    return derived;
  }

  public boolean getRemote() {
    return isRemoteMode();
  }

  /** The variable {@code load}, which says how active the object is to be: 1 unless changed. */
  public UVar getLoad() {
    UVar known = variables.get("load");
    if (known != null) {
      return known;
    }
    UVar bound = new UVar(this, "load");
    if (bound.getUValue().isVoid()) {
      bound.setValue(1);
    }
    variables.put("load", bound);
    return bound;
  }

  // ------------------------------------------------------------------ variables and events

  /** Makes a variable the slot of that name of this object. */
  protected void UBindVar(UVar v, String slot) {
    v.init(name, slot, getUContext());
    variables.put(slot, v);
  }

  /** Makes variables slots of this object: {@code UBindVars(x, "x", y, "y")}. */
  protected void UBindVars(Object... variablesAndNames) {
    if (variablesAndNames.length % 2 != 0) {
      throw new IllegalArgumentException("UBindVars wants pairs of a UVar and its name");
    }
    for (int i = 0; i < variablesAndNames.length; i += 2) {
      UBindVar((UVar) variablesAndNames[i], (String) variablesAndNames[i + 1]);
    }
  }

  /** Makes an event the slot of that name of this object. */
  protected void UBindEvent(UEvent e, String slot) {
    e.init(name, slot, getUContext());
  }

  /**
   * Has a variable of this object two values (manual, "The special case of sensor/actuator
   * variables"): this module reads the target that the others have written, and what it writes is
   * what they read.
   */
  protected void UOwned(UVar v) {
    v.setOwned();
  }

  /** The former name of {@link #UOwned}. */
  protected void USensor(UVar v) {
    UOwned(v);
  }

  /** Has each change of a variable sent here. */
  protected void USync(UVar v) {
    v.keepSynchronized();
  }

  /** The variable of this object that is bound to a slot; another one is bound when it is used. */
  UVar variable(String slotOrName) {
    UVar own = variables.get(slotOrName);
    if (own != null) {
      return own;
    }
    UVar other = new UVar();
    other.init(
        slotOrName.indexOf('.') < 0 ? name : slotOrName.substring(0, slotOrName.lastIndexOf('.')),
        slotOrName.substring(slotOrName.lastIndexOf('.') + 1),
        getUContext());
    notifications.add(other::close);
    return other;
  }

  // ------------------------------------------------------------------ functions

  /** Binds a method of this object, which has no namesake (manual, "Binding functions"). */
  protected void UBindFunction(String methodName) {
    UBindFunction(this, methodName);
  }

  /** Binds a method of another object as a function of this one. */
  protected void UBindFunction(Object object, String methodName) {
    bindFunction(object, Methods.find(object.getClass(), methodName), methodName);
  }

  /**
   * Binds the method with arguments of these types.
   *
   * @param argumentTypes the names of the types: {@code double}, {@code java.lang.String}
   */
  protected void UBindFunction(Object object, String methodName, String[] argumentTypes) {
    bindFunction(object, Methods.find(object.getClass(), methodName, argumentTypes), methodName);
  }

  /** Binds a method under its name. */
  protected void UBindFunction(Object object, Method method) {
    bindFunction(object, method, method.getName());
  }

  /** Binds a method under another name. */
  protected void UBindFunctionRename(String methodName, String urbiName) {
    bindFunction(this, Methods.find(getClass(), methodName), urbiName);
  }

  /** Binds methods of this object. */
  protected void UBindFunctions(String... methodNames) {
    for (String methodName : methodNames) {
      UBindFunction(methodName);
    }
  }

  /** Binds methods of another object as functions of this one. */
  protected void UBindFunctions(Object object, String... methodNames) {
    for (String methodName : methodNames) {
      UBindFunction(object, methodName);
    }
  }

  private void bindFunction(Object object, Method method, String urbiName) {
    bind(urbiName, Methods.callback(name + "." + urbiName, object, method));
  }

  /** Binds what can be called. */
  protected final void bind(String urbiName, UCallback function) {
    getUContext().bindFunction(this, urbiName, function);
  }

  /** Binds a method reference: {@code bind("add", this::add)}. */
  protected final <R> void bind(String urbiName, UFunctions.F0<R> function) {
    bindReference(urbiName, function);
  }

  protected final <A, R> void bind(String urbiName, UFunctions.F1<A, R> function) {
    bindReference(urbiName, function);
  }

  protected final <A, B, R> void bind(String urbiName, UFunctions.F2<A, B, R> function) {
    bindReference(urbiName, function);
  }

  protected final <A, B, C, R> void bind(String urbiName, UFunctions.F3<A, B, C, R> function) {
    bindReference(urbiName, function);
  }

  protected final <A, B, C, D, R> void bind(
      String urbiName, UFunctions.F4<A, B, C, D, R> function) {
    bindReference(urbiName, function);
  }

  protected final void bind(String urbiName, UFunctions.P0 function) {
    bindReference(urbiName, function);
  }

  protected final <A> void bind(String urbiName, UFunctions.P1<A> function) {
    bindReference(urbiName, function);
  }

  protected final <A, B> void bind(String urbiName, UFunctions.P2<A, B> function) {
    bindReference(urbiName, function);
  }

  protected final <A, B, C> void bind(String urbiName, UFunctions.P3<A, B, C> function) {
    bindReference(urbiName, function);
  }

  protected final <A, B, C, D> void bind(String urbiName, UFunctions.P4<A, B, C, D> function) {
    bindReference(urbiName, function);
  }

  private void bindReference(String urbiName, UFunctions.Bindable function) {
    bind(urbiName, UFunctions.callback(name + "." + urbiName, function));
  }

  /**
   * Binds a method of which each call runs on a thread of its own (manual, "Asynchronous binding").
   */
  protected void UBindThreadedFunction(String methodName, LockMode lock) {
    UBindThreadedFunctionRename(methodName, methodName, new LockSpec(lock));
  }

  protected void UBindThreadedFunction(String methodName, LockSpec lock) {
    UBindThreadedFunctionRename(methodName, methodName, lock);
  }

  protected void UBindThreadedFunctionRename(String methodName, String urbiName, LockMode lock) {
    UBindThreadedFunctionRename(methodName, urbiName, new LockSpec(lock));
  }

  protected void UBindThreadedFunctionRename(String methodName, String urbiName, LockSpec lock) {
    bindThreaded(this, Methods.find(getClass(), methodName), urbiName, lock);
  }

  /** Binds a method of another object, or one with namesakes, to run on a thread of its own. */
  protected void UBindThreadedFunction(
      Object object, String methodName, String[] argumentTypes, LockSpec lock) {
    bindThreaded(
        object, Methods.find(object.getClass(), methodName, argumentTypes), methodName, lock);
  }

  void bindThreaded(Object object, Method method, String urbiName, LockSpec lock) {
    UCallback callback = Methods.callback(name + "." + urbiName, object, method);
    bind(urbiName, callback.threaded(lock, queue(lock, urbiName)));
  }

  /** The calls that a threaded one excludes; null for none. */
  private @Nullable UTaskQueue queue(LockSpec lock, String what) {
    return switch (lock.lockMode()) {
      case LOCK_NONE -> null;
      case LOCK_FUNCTION -> queues.computeIfAbsent(what, key -> new UTaskQueue());
      case LOCK_INSTANCE -> queue;
      case LOCK_CLASS -> type.queue();
      case LOCK_MODULE -> type.module().queue();
    };
  }

  /** Limits the number of threads that run threaded calls of this process; 0 for any number. */
  protected void setThreadLimit(int threads) {
    getUContext().setThreadLimit(threads);
  }

  // ------------------------------------------------------------------ notifications

  /**
   * Has a method called after each change of a variable (manual, "Notification of a variable
   * change"). It takes nothing, the {@link UVar}, or the value in any type.
   */
  protected void UNotifyChange(UVar v, String methodName) {
    notifyChange(v, Methods.find(getClass(), methodName), null);
  }

  protected void UNotifyChange(UVar v, String methodName, String[] argumentTypes) {
    notifyChange(v, Methods.find(getClass(), methodName, argumentTypes), null);
  }

  protected void UNotifyChange(UVar v, Method method) {
    notifyChange(v, method, null);
  }

  /**
   * @param variableName {@code object.slot}, or a slot of this object
   */
  protected void UNotifyChange(String variableName, String methodName) {
    UNotifyChange(variable(variableName), methodName);
  }

  protected void UNotifyChange(String variableName, String methodName, String[] argumentTypes) {
    UNotifyChange(variable(variableName), methodName, argumentTypes);
  }

  protected void UNotifyChange(String variableName, Method method) {
    UNotifyChange(variable(variableName), method);
  }

  /**
   * Has a method called on a thread of its own after each change. It takes nothing or the value,
   * not the {@link UVar}: that may have changed again.
   */
  protected void UNotifyThreadedChange(UVar v, String methodName, LockMode lock) {
    UNotifyThreadedChange(v, methodName, new LockSpec(lock));
  }

  protected void UNotifyThreadedChange(UVar v, String methodName, LockSpec lock) {
    notifyChange(v, Methods.find(getClass(), methodName), lock);
  }

  protected void UNotifyThreadedChange(String variableName, String methodName, LockMode lock) {
    UNotifyThreadedChange(variable(variableName), methodName, lock);
  }

  protected void UNotifyThreadedChange(String variableName, String methodName, LockSpec lock) {
    UNotifyThreadedChange(variable(variableName), methodName, lock);
  }

  void notifyChange(UVar v, Method method, @Nullable LockSpec lock) {
    UCallback callback = notification(v, method, lock);
    notifications.add(v.onChange(this, callback));
  }

  /**
   * Has a method called before each access to a variable, so that it may set the value. It takes
   * nothing, the {@link UVar}, or the value in any type.
   */
  protected void UNotifyAccess(UVar v, String methodName) {
    notifyAccess(v, Methods.find(getClass(), methodName));
  }

  protected void UNotifyAccess(UVar v, String methodName, String[] argumentTypes) {
    notifyAccess(v, Methods.find(getClass(), methodName, argumentTypes));
  }

  protected void UNotifyAccess(UVar v, Method method) {
    notifyAccess(v, method);
  }

  protected void UNotifyAccess(String variableName, String methodName) {
    UNotifyAccess(variable(variableName), methodName);
  }

  protected void UNotifyAccess(String variableName, String methodName, String[] argumentTypes) {
    UNotifyAccess(variable(variableName), methodName, argumentTypes);
  }

  protected void UNotifyAccess(String variableName, Method method) {
    UNotifyAccess(variable(variableName), method);
  }

  void notifyAccess(UVar v, Method method) {
    notifications.add(v.onAccess(this, notification(v, method, null)));
  }

  /** The former name of {@link #UNotifyAccess(UVar, String)}. */
  protected void UNotifyOnRequest(UVar v, String methodName) {
    UNotifyAccess(v, methodName);
  }

  protected void UNotifyOnRequest(UVar v, String methodName, String[] argumentTypes) {
    UNotifyAccess(v, methodName, argumentTypes);
  }

  protected void UNotifyOnRequest(UVar v, Method method) {
    UNotifyAccess(v, method);
  }

  protected void UNotifyOnRequest(String variableName, String methodName) {
    UNotifyAccess(variableName, methodName);
  }

  protected void UNotifyOnRequest(String variableName, String methodName, String[] argumentTypes) {
    UNotifyAccess(variableName, methodName, argumentTypes);
  }

  protected void UNotifyOnRequest(String variableName, Method method) {
    UNotifyAccess(variableName, method);
  }

  private UCallback notification(UVar v, Method method, @Nullable LockSpec lock) {
    String shown = name + "." + method.getName();
    UCallback callback = Methods.callback(shown, this, method);
    if (callback.arity() > 1) {
      throw new IllegalArgumentException(
          shown + " is for notifications, but has " + callback.arity() + " arguments");
    }
    if (callback.arity() == 1 && UVar.class == callback.parameterTypes().getFirst()) {
      if (lock != null) {
        throw new IllegalArgumentException(
            shown + " is for threaded notifications, but has a UVar as argument");
      }
      MethodHandle handle = MethodHandles.insertArguments(callback.handle(), 0, v);
      callback = UCallback.of(shown, handle);
    }
    return lock == null ? callback : callback.threaded(lock, queue(lock, v.getName()));
  }

  // ------------------------------------------------------------------ hubs

  /** Registers with the hub of that class (manual, "Using hubs to group objects"). */
  protected void URegister(String hubClass) {
    UObjectHub hub = getUObjectHub(hubClass);
    if (hub == null) {
      throw new IllegalArgumentException("hub name '" + hubClass + "' is unknown");
    }
    hub.addMember(this);
    hubs.add(hub);
  }

  protected void URegister(Class<? extends UObjectHub> hubClass) {
    URegister(UModule.simpleName(hubClass));
  }

  /** The hub with which it has registered last, or null. */
  public @Nullable UObjectHub getObjecthub() {
    return hubs.isEmpty() ? null : hubs.getLast();
  }

  // ------------------------------------------------------------------ the end

  /**
   * Called when the urbiscript object has gone, and perhaps once more when the garbage collector
   * comes by. Programs of Urbi 2.7 override it; {@link AutoCloseable} is for others.
   */
  @Override
  // Deprecated in Java, part of the interface of 2.7.
  @SuppressWarnings("removal")
  protected void finalize() {}

  /**
   * Ends all that the object has bound. The context calls it when the urbiscript object has gone; a
   * second time does nothing.
   */
  public final void clean() {
    if (cleaned.getAndSet(true)) {
      return;
    }
    List<Runnable> ended = new ArrayList<>(notifications);
    notifications.clear();
    ended.forEach(Runnable::run);
    hubs.forEach(hub -> hub.delMember(this));
    getUContext().detach(this);
    variables.values().forEach(UVar::close);
    ended("finalizing", this::finalize);
    if (this instanceof AutoCloseable resource) {
      ended("closing", resource::close);
    }
  }

  private interface EndAction {
    void run() throws Exception;
  }

  private void ended(String how, EndAction ending) {
    try {
      ending.run();
    } catch (Throwable e) {
      String what = "exception caught while " + how + " " + name;
      Log.error(what, e);
      getUContext().report(what + ": " + e);
    }
  }

  @Override
  public String toString() {
    return name;
  }
}
