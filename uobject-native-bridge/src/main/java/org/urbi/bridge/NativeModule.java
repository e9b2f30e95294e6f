package org.urbi.bridge;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import urbi.UClass;
import urbi.UContext;
import urbi.UHubClass;
import urbi.UModule;
import urbi.UModuleException;
import urbi.UObjectMode;
import urbi.UTaskQueue;

/**
 * A shared library with UObjects that are written in C++ (manual, "The UObject API").
 *
 * <p>It is unloaded when it has been closed and the last of its objects has been deleted. Libraries
 * that are loaded twice share nothing.
 */
public final class NativeModule implements AutoCloseable {
  private static final long BOUNDARY_VERSION = 2;

  /** The files that are loaded, by what identifies them to the system's loader. */
  private static final Map<Object, NativeModule> LOADED = new HashMap<>();

  private static final int MAX_SPELLINGS = 500;

  private static final AtomicInteger SPELLINGS = new AtomicInteger();

  private final String shown;
  private final NativeThreads threads = new NativeThreads();
  private final Object fileKey;
  private final JnaLibrary library;
  private final ModuleFunctions entries;
  private final boolean yields;
  private final UModule module;
  private final UTaskQueue queue = new UTaskQueue();
  private final Map<String, UTaskQueue> classQueues = new ConcurrentHashMap<>();
  private final List<NativeContext> contexts = new ArrayList<>();

  /** This itself until it is closed, and each of its objects. */
  private final AtomicInteger users = new AtomicInteger(1);

  private final AtomicBoolean closed = new AtomicBoolean();

  private NativeModule(Path file, Object fileKey, JnaLibrary library) {
    this.shown = file.getFileName().toString();
    this.fileKey = fileKey;
    this.library = library;
    this.entries = library.entries();
    this.yields = library.yields();
    this.module = new UModule(shown, this::close);
  }

  /**
   * Loads a library.
   *
   * @throws UModuleException if there is no such file, if it is no shared library for this machine,
   *     lacks a symbol, or has no UObject
   */
  public static NativeModule load(Path file) {
    Path absolute = file.toAbsolutePath().normalize();
    String shown = file.toString();
    if (!Files.isRegularFile(absolute)) {
      throw new UModuleException("cannot load " + shown + ": there is no such file");
    }
    LoaderErrors.checkHeader(absolute, shown);
    synchronized (LOADED) {
      Object key = key(absolute);
      boolean copied = LOADED.containsKey(key);
      Path path = copied ? copy(absolute, shown) : absolute;
      JnaLibrary library;
      try {
        library = JnaLibrary.open(spelling(path), shown);
      } finally {
        if (copied) {
          path.toFile().delete();
        }
      }
      try {
        NativeModule made = new NativeModule(file, copied ? new Object() : key, library);
        made.open(shown);
        LOADED.put(made.fileKey, made);
        return made;
      } catch (RuntimeException e) {
        library.close();
        throw e;
      }
    }
  }

  /**
   * The UObjects of the program in whose process this is.
   *
   * @param shown what it is called
   * @throws UModuleException if it has none, or does not export what they need
   */
  static NativeModule ofProcess(String shown) {
    NativeModule made = new NativeModule(Path.of(shown), new Object(), JnaLibrary.ofProcess(shown));
    made.open(shown);
    return made;
  }

  private static Object key(Path file) {
    try {
      Object key = Files.readAttributes(file, BasicFileAttributes.class).fileKey();
      return key == null ? file.toRealPath() : key;
    } catch (IOException e) {
      return file;
    }
  }

  /**
   * Another name of the same file: the loader would give the library of old for the same name. It
   * also tells the module where it is, before it can ask: see {@code loading_mode} in {@code
   * urbi/ucontext-impl.hh}.
   */
  private static Path spelling(Path file) {
    int own = SPELLINGS.getAndIncrement() % MAX_SPELLINGS;
    return Path.of(file.getParent() + "/.".repeat(2 * own + (isPlugged() ? 1 : 2)))
        .resolve(file.getFileName());
  }

  /** Whether a kernel loads: a process of its own has no context yet when it does. */
  private static boolean isPlugged() {
    try {
      return UContext.current().getRunningMode() == UObjectMode.MODE_PLUGIN;
    } catch (IllegalStateException e) {
      return false;
    }
  }

  /** A file that is loaded already is loaded again from a copy, or both would share everything. */
  private static Path copy(Path file, String shown) {
    try {
      Path copy = Files.createTempFile("urbi-", "-" + file.getFileName());
      Files.copy(file, copy, StandardCopyOption.REPLACE_EXISTING);
      return copy;
    } catch (IOException e) {
      throw new UModuleException("cannot copy " + shown + ": " + e.getMessage(), e);
    }
  }

  private void open(String path) {
    long version = entries.version();
    if (version != BOUNDARY_VERSION) {
      throw new UModuleException(
          "cannot load "
              + path
              + ": it was compiled with the headers of another version of Urbi ("
              + version
              + ", not "
              + BOUNDARY_VERSION
              + "): compile it again");
    }
    CallFrame frame = CallFrame.take();
    try {
      frame.prepare(0, 0, 0);
      if (entries.open(frame.exchange) == Exchange.FAILED) {
        throw new UModuleException("cannot load " + path + ": " + frame.error());
      }
      declare(frame.reply(), path);
    } finally {
      frame.release(entries);
    }
  }

  private void declare(ValueReader reply, String path) {
    while (!reply.ended()) {
      String kind = reply.text();
      String name = reply.text();
      if (kind.equals("hub")) {
        module.add(new UHubClass(name, module, created -> NativeHub.create(this, created)));
      } else {
        module.add(new UClass(name, module, created -> NativeObject.create(this, name, created)));
      }
    }
    if (module.classes().isEmpty() && module.hubs().isEmpty()) {
      throw new UModuleException("no UObject in " + path + ": nothing is declared by UStart");
    }
  }

  /** Its classes, to be started in contexts. */
  public UModule module() {
    return module;
  }

  /** The name of the file. */
  public String name() {
    return shown;
  }

  ModuleFunctions entries() {
    return entries;
  }

  /** Whether its code yields. */
  boolean yields() {
    return yields;
  }

  /** What this module has in a context. */
  NativeContext in(UContext context) {
    synchronized (contexts) {
      for (NativeContext each : contexts) {
        if (each.context() == context) {
          return each;
        }
      }
      NativeContext made = new NativeContext(this, context);
      contexts.add(made);
      return made;
    }
  }

  /** The threads that the module has made. */
  NativeThreads threads() {
    return threads;
  }

  UTaskQueue queue() {
    return queue;
  }

  UTaskQueue classQueue(String className) {
    return classQueues.computeIfAbsent(className, name -> new UTaskQueue());
  }

  /** An object lives from now on. */
  void retain() {
    users.incrementAndGet();
  }

  /** An object has been deleted. */
  void release() {
    if (users.decrementAndGet() == 0) {
      unload();
    }
  }

  /** No more objects are made: it is unloaded as soon as there are none. */
  @Override
  public void close() {
    if (closed.getAndSet(true)) {
      return;
    }
    // Code in C++ may let others run, who load and call, too: no monitor is held.
    inUse().forEach(NativeContext::endHubs);
    release();
  }

  private List<NativeContext> inUse() {
    synchronized (contexts) {
      return List.copyOf(contexts);
    }
  }

  /** A library whose code a thread still executes stays loaded: what comes next is a copy of it. */
  private void unload() {
    boolean ended = true;
    for (NativeContext each : inUse()) {
      ended &= each.close();
    }
    synchronized (contexts) {
      contexts.clear();
    }
    ended &= !threads.anyAlive();
    if (ended) {
      synchronized (LOADED) {
        library.close();
        LOADED.remove(fileKey);
      }
    }
  }

  @Override
  public String toString() {
    return shown;
  }
}
