package org.urbi.bridge;

import com.sun.jna.CallbackThreadInitializer;
import com.sun.jna.Library;
import com.sun.jna.Native;
import com.sun.jna.NativeLibrary;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import urbi.UModuleException;

/** A shared library, as JNA loads it, calls it and is called by it. */
final class JnaLibrary implements AutoCloseable {
  /** Everything is resolved at once, and seen by nobody else. */
  private static final int RTLD_NOW = 2;

  /**
   * The library of C++ itself, kept for good. Were it loaded by the first module that needs it, it
   * would use what that module has of its templates, and the module could never be unloaded.
   */
  private static final String CXX_LIBRARY = "libstdc++.so.6";

  private static final List<String> FUNCTIONS =
      List.of(
          "urbi_module_version",
          "urbi_module_open",
          "urbi_module_create",
          "urbi_module_destroy",
          "urbi_module_invoke",
          "urbi_module_forget",
          "urbi_module_free");

  /** What a library exports only if it calls it. */
  private static final String YIELD = "urbi_module_yield";

  /**
   * What libraries call. Given as an argument to a function that is mapped directly, it is called
   * without boxing, which takes half as long.
   */
  private static final JnaHost HOST = host();

  private final NativeLibrary library;
  private final Class<?> mapped;
  private final ModuleFunctions entries;

  private JnaLibrary(NativeLibrary library, Class<?> mapped, ModuleFunctions entries) {
    this.library = library;
    this.mapped = mapped;
    this.entries = entries;
  }

  static {
    try {
      NativeLibrary.getInstance(CXX_LIBRARY, Map.of(Library.OPTION_OPEN_FLAGS, RTLD_NOW));
    } catch (UnsatisfiedLinkError e) {
      // Modules then use another one, or bring their own.
    }
  }

  private static JnaHost host() {
    JnaHost host = RequestHandler::carryOut;
    // Threads of C++ stay known to the JVM: to attach one for each call takes 70 times as long. It
    // has to be said before the callback is used for the first time.
    Native.setCallbackThreadInitializer(
        host, new CallbackThreadInitializer(true, false, NativeThreads.NAME));
    return host;
  }

  /**
   * Loads a library.
   *
   * @param shown what errors call it
   * @throws UModuleException if it cannot be loaded, or is no module
   */
  static JnaLibrary open(Path file, String shown) {
    try {
      return of(
          NativeLibrary.getInstance(file.toString(), Map.of(Library.OPTION_OPEN_FLAGS, RTLD_NOW)),
          shown);
    } catch (UnsatisfiedLinkError e) {
      throw new UModuleException(LoaderErrors.text(file, shown, e.getMessage()), e);
    }
  }

  /** The program in whose process this is; its symbols have to be exported. */
  static JnaLibrary ofProcess(String shown) {
    return of(NativeLibrary.getProcess(), shown);
  }

  private static JnaLibrary of(NativeLibrary library, String shown) {
    try {
      for (String function : FUNCTIONS) {
        checkFunction(library, function, shown);
      }
      Class<?> mapped = new CopyLoader().copy();
      Native.register(mapped, library);
      ModuleFunctions entries =
          (ModuleFunctions) mapped.getConstructor(JnaHost.class).newInstance(HOST);
      return new JnaLibrary(library, mapped, entries);
    } catch (ReflectiveOperationException | IOException e) {
      library.close();
      throw new UModuleException("cannot load " + shown + ": " + e.getMessage(), e);
    } catch (RuntimeException e) {
      library.close();
      throw e;
    }
  }

  private static void checkFunction(NativeLibrary library, String name, String shown) {
    try {
      library.getFunction(name);
    } catch (UnsatisfiedLinkError e) {
      throw new UModuleException(
          "no UObject in "
              + shown
              + ": it has no symbol "
              + name
              + ", which urbi/uobject.hh defines",
          e);
    }
  }

  ModuleFunctions entries() {
    return entries;
  }

  /** Whether its code yields, and may have to be left in the middle of a call. */
  boolean yields() {
    try {
      library.getFunction(YIELD);
      return true;
    } catch (UnsatisfiedLinkError e) {
      return false;
    }
  }

  /** Unloads it: none of its functions may be called any more. */
  @Override
  public void close() {
    Native.unregister(mapped);
    library.close();
  }

  /** Defines one class anew. */
  private static final class CopyLoader extends ClassLoader {
    CopyLoader() {
      super(JnaLibrary.class.getClassLoader());
    }

    Class<?> copy() throws IOException {
      String name = JnaFunctions.class.getName();
      try (InputStream in =
          JnaFunctions.class.getResourceAsStream(JnaFunctions.class.getSimpleName() + ".class")) {
        byte[] bytes = in.readAllBytes();
        return defineClass(name, bytes, 0, bytes.length, JnaFunctions.class.getProtectionDomain());
      }
    }
  }
}
