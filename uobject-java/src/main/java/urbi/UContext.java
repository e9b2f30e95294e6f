package urbi;

import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * Where UObjects live: plugged into a kernel, or in a process that is connected to one. A UObject
 * does not know which; it does everything through these methods, mostly by way of {@link UObject},
 * {@link UVar}, {@link UEvent} and {@link UObjectHub}, so that it runs both ways unchanged.
 *
 * <p>Every method may be called from any thread. On the thread that the context itself uses to call
 * UObjects a method is carried out at once; on any other it waits until the context has carried it
 * out, unless it says otherwise.
 *
 * <p>Names are those of urbiscript: {@code "Adder"}, {@code "Adder.v"}, {@code "Global.x"}. What an
 * object is called ({@link UObject#get__name}) is unique in its kernel, and a slot of {@code
 * uobjects}.
 *
 * <p>What a context calls it has been given as a {@link UCallback}: it converts the arguments to
 * the types which that declares, and respects {@link UCallback#queue}. Errors of a callback never
 * end the context: those of a function become an exception for its caller, those of the others are
 * reported to people.
 */
public interface UContext {
  /** Whether the kernel is in this process. */
  UObjectMode getRunningMode();

  /**
   * The server to which this process is connected; null in the process of the kernel, and in those
   * that it has made for modules.
   */
  default @Nullable InetSocketAddress server() {
    return null;
  }

  // ------------------------------------------------------------------ classes and objects

  /**
   * Makes a class known to urbiscript: creates the object {@code uobjects.NAME} and, by {@link
   * UClass#create}, its Java side, the prototype. Every {@code NAME.new(arguments)} of urbiscript
   * makes another pair, and then calls the function {@code init} that the object has bound, if it
   * has: one that returns a number other than 0, or throws, has {@code new} fail.
   *
   * <p>A class of a name that exists replaces it: the urbiscript objects stay, and get new objects
   * behind them, see {@link UModule}.
   *
   * @throws RuntimeException what the constructor threw
   */
  void start(UClass type);

  /** Makes the one instance of a hub (manual, "Using Hubs to Group Objects"). */
  void startHub(UHubClass type);

  /**
   * A UObject is being constructed: the context prepares the urbiscript object of that name. Called
   * by the constructor of {@link UObject}, before anything is bound.
   *
   * @param name null for an object that Java code makes by itself: the context chooses one
   * @return the name
   */
  String attach(UObject object, @Nullable String name);

  /** Forgets an object with all that it has bound; called by {@link UObject#clean}. */
  void detach(UObject object);

  /** The object of that name, or null: one of this context, not of another process. */
  @Nullable UObject getUObject(String name);

  /** The hub of that name, or null. */
  @Nullable UObjectHub getUObjectHub(String name);

  /**
   * The variables of the environment. For a plugged object that is replayed, they are those of the
   * recorded run, so that it does the same again; it asks in its constructor or in a function that
   * the kernel calls, and not on a thread of its own.
   */
  default Map<String, String> environment() {
    return System.getenv();
  }

  // ------------------------------------------------------------------ what objects bind

  /**
   * Makes a function a method of the urbiscript object. A function of that name is replaced.
   *
   * <p>The result is converted by its dynamic type; {@code void} is void. If it is a {@link
   * java.util.concurrent.CompletionStage}, the calling job waits for it while others run. If the
   * job is stopped meanwhile, a plugged object has its {@code CompletableFuture} cancelled.
   */
  void bindFunction(UObject object, String name, UCallback function);

  /**
   * The variable of that name, which is created if the object has none, and becomes one that can be
   * watched.
   *
   * @param name {@code object.slot}
   * @throws IllegalArgumentException if there is no such object: {@code UVar creation on non
   *     existing object: NAME}
   */
  USlot variable(String name);

  /**
   * A port of an object, into which urbiscript can lead the values of variables ({@code source.&val
   * >> sink.&input}). It keeps no value: it passes on.
   */
  USlot inputPort(String name);

  /**
   * The event of that name, which is created if the object has none.
   *
   * @return what emits it: it does so as {@code event!(arguments)}
   */
  UEmitter event(String name);

  /**
   * Calls a function without arguments again and again.
   *
   * @param owner a {@link UObject} or a {@link UObjectHub}: it ends with it
   * @param milliseconds the period; 0 for as often as is useful. It is never shorter than the
   *     kernel's own, {@code System.period}.
   * @param afterPass whether just after a pass of urbiscript code, as {@link UObject#update}, or
   *     just before
   * @return what ends it; a second time does nothing
   */
  Runnable every(Object owner, double milliseconds, UCallback function, boolean afterPass);

  // ------------------------------------------------------------------ urbiscript

  /**
   * Has urbiscript code executed, as if a client of its own had sent it: it is a whole number of
   * statements, and runs later. Does not wait.
   */
  void send(String code);

  /** Calls {@code object.method(arguments)}, later; the result is dropped. Does not wait. */
  void call(String object, String method, UValue... arguments);

  /** Emits a message to people, on a channel as {@code urbi} shows them; does not wait. */
  void report(String message);

  // ------------------------------------------------------------------ time and threads

  /**
   * Lets others run for a while: in a function that the context calls synchronously the calling job
   * sleeps, and the kernel goes on; other threads just sleep.
   */
  void yieldFor(Duration time);

  /**
   * Executes native code that may call {@link #yieldFor}. Such code cannot be left in the middle: a
   * kernel executes it on a thread of its own, always the same, for which it waits unless the code
   * yields.
   */
  default <T> T executeNative(Supplier<T> code) {
    return code.get();
  }

  /**
   * Has nothing done but what this thread asks for, until {@link #unlock}: functions of UObjects
   * are not called meanwhile, and urbiscript stands still if it is in the same process. The lock
   * ends with the thread, and when a job would be ended that holds the kernel for so long. It may
   * be locked several times. Of no effect in code that the context has called, which excludes
   * everything else already.
   */
  void lock();

  /** Ends what {@link #lock} began. */
  void unlock();

  /** Where threaded functions and notifications run. */
  Executor threads();

  /** Limits the number of threads that run at a time; 0 for any number. */
  void setThreadLimit(int threads);

  // ------------------------------------------------------------------ the current one

  /**
   * The context to which the code of this thread belongs: that which has called it, or which loads
   * it, or that of the module from which it is.
   *
   * @throws IllegalStateException if there is none
   */
  static UContext current() {
    return CurrentContext.get();
  }

  /**
   * Says to which context the code belongs that this thread executes from now on; for those who
   * implement one.
   *
   * @param context null for none
   * @return the one before, or null
   */
  static UContext enter(UContext context) {
    return CurrentContext.enter(context);
  }
}
