package org.urbi.ros.rcl;

import java.lang.foreign.AddressLayout;
import java.lang.foreign.Arena;
import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.Linker;
import java.lang.foreign.MemoryLayout;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.SegmentAllocator;
import java.lang.foreign.StructLayout;
import java.lang.foreign.ValueLayout;
import java.lang.invoke.MethodHandle;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.function.Function;
import org.urbi.ros.graph.RosException;

/**
 * Calls functions of C by their names. Their signatures are those of the arguments: a {@link
 * MemorySegment} is a pointer, a String one to its characters, a {@link Structure} is passed as it
 * is.
 */
// Whoever calls C is believed: a wrong signature or length is the end of the process.
@SuppressWarnings("restricted")
final class CFunctions {
  private static final Linker LINKER = Linker.nativeLinker();
  private static final AddressLayout POINTER =
      ValueLayout.ADDRESS.withTargetLayout(
          MemoryLayout.sequenceLayout(Long.MAX_VALUE, ValueLayout.JAVA_BYTE));

  /** No structure that a function returns is larger; C writes what it has. */
  private static final StructLayout LARGEST = layout(1024);

  /** A structure that is an argument itself, not a pointer to it. */
  record Structure(MemorySegment content) {}

  private final Function<String, MemorySegment> symbols;
  private final Map<String, MethodHandle> handles = new ConcurrentHashMap<>();

  /**
   * @param symbols where functions are; {@link MemorySegment#NULL} for those that are not there
   */
  CFunctions(Function<String, MemorySegment> symbols) {
    this.symbols = symbols;
  }

  private static StructLayout layout(long bytes) {
    return MemoryLayout.structLayout(
        MemoryLayout.sequenceLayout(bytes / Long.BYTES, ValueLayout.JAVA_LONG));
  }

  private static MemoryLayout layout(Object argument) {
    return switch (argument) {
      case MemorySegment pointer -> ValueLayout.ADDRESS;
      case String text -> ValueLayout.ADDRESS;
      case Long number -> ValueLayout.JAVA_LONG;
      case Integer number -> ValueLayout.JAVA_INT;
      case Boolean flag -> ValueLayout.JAVA_BOOLEAN;
      case Structure structure -> layout(structure.content.byteSize());
      default -> throw new IllegalArgumentException(argument.getClass().getName());
    };
  }

  private static Object passed(Object argument, Arena arena) {
    return switch (argument) {
      case String text -> arena.allocateFrom(text);
      case Structure structure -> structure.content;
      default -> argument;
    };
  }

  private static MemoryLayout[] layouts(Object[] arguments) {
    MemoryLayout[] layouts = new MemoryLayout[arguments.length];
    for (int i = 0; i < layouts.length; i++) layouts[i] = layout(arguments[i]);
    return layouts;
  }

  private MethodHandle handle(String name, FunctionDescriptor signature) {
    return handles.computeIfAbsent(
        name,
        wanted -> {
          MethodHandle plain = LINKER.downcallHandle(symbol(wanted), signature);
          return plain.asSpreader(Object[].class, plain.type().parameterCount());
        });
  }

  /**
   * Where a function is.
   *
   * @throws RosException if it is not there
   */
  MemorySegment symbol(String name) {
    MemorySegment found = symbols.apply(name);
    if (found.equals(MemorySegment.NULL))
      throw new RosException("the installed ROS 2 has no function " + name);
    return found;
  }

  private static Object call(MethodHandle handle, Object... arguments) {
    try (Arena arena = Arena.ofConfined()) {
      for (int i = 0; i < arguments.length; i++) arguments[i] = passed(arguments[i], arena);
      return handle.invoke(arguments);
    } catch (RuntimeException | Error e) {
      throw e;
    } catch (Throwable e) {
      throw new IllegalStateException(e);
    }
  }

  /** The number that a function returns, usually whether it did what it should. */
  int number(String name, Object... arguments) {
    FunctionDescriptor signature = FunctionDescriptor.of(ValueLayout.JAVA_INT, layouts(arguments));
    return (int) call(handle(name, signature), arguments);
  }

  /** The pointer that a function returns. */
  MemorySegment pointer(String name, Object... arguments) {
    FunctionDescriptor signature = FunctionDescriptor.of(POINTER, layouts(arguments));
    return (MemorySegment) call(handle(name, signature), arguments);
  }

  /** Calls a function that returns nothing. */
  void run(String name, Object... arguments) {
    call(handle(name, FunctionDescriptor.ofVoid(layouts(arguments))), arguments);
  }

  /** So many bytes to which a pointer in a structure points. */
  static MemorySegment content(MemorySegment structure, long at, long length) {
    return structure.get(ValueLayout.ADDRESS, at).reinterpret(length);
  }

  /** The characters to which a pointer of C points; none for none. */
  static String text(MemorySegment pointer) {
    return pointer.equals(MemorySegment.NULL)
        ? ""
        : pointer.reinterpret(Long.MAX_VALUE).getString(0);
  }

  /** The structure that a function returns which has no arguments; as many bytes as any has. */
  MemorySegment structure(String name, Arena arena) {
    MethodHandle handle = handle(name, FunctionDescriptor.of(LARGEST));
    return (MemorySegment) call(handle, (SegmentAllocator) arena::allocate);
  }

  /**
   * Does what can fail.
   *
   * @throws RosException if it did, with what C says about it
   */
  void check(String name, Object... arguments) {
    if (number(name, arguments) != 0) throw new RosException(name + ": " + lastError());
  }

  /** Ends something, which can fail, too: that is told, with what C says about it. */
  void end(Consumer<? super RosException> troubles, String name, Object... arguments) {
    if (number(name, arguments) != 0) troubles.accept(new RosException(name + ": " + lastError()));
  }

  /** What the last function that failed in this thread says; it is forgotten then. */
  String lastError() {
    try (Arena arena = Arena.ofConfined()) {
      String text = structure("rcutils_get_error_string", arena).getString(0);
      run("rcutils_reset_error");
      return text;
    }
  }
}
