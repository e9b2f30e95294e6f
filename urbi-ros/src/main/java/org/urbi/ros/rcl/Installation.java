package org.urbi.ros.rcl;

import java.io.File;
import java.lang.foreign.MemorySegment;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.urbi.ros.graph.RosException;

/** A ROS 2 that is installed here. */
public final class Installation {
  private static final String PREFIXES = "AMENT_PREFIX_PATH";
  private static final String LIBRARY = "librcl.so";

  /** What only Iron and later have: before, identifiers and events were others. */
  private static final String SINCE_IRON = "rcl_service_configure_service_introspection";

  private final List<Path> folders;
  private final Path library;
  private final Libraries libraries;
  private final CFunctions functions;

  private Installation(List<Path> folders, Path library) {
    this.folders = folders;
    this.library = library;
    libraries = new Libraries(folders);
    functions = new CFunctions(libraries::find);
  }

  /** The one of which {@code AMENT_PREFIX_PATH} tells, if it has {@code rcl}. */
  public static Optional<Installation> of(Map<String, String> environment) {
    List<Path> folders =
        Stream.of(environment.getOrDefault(PREFIXES, "").split(File.pathSeparator))
            .filter(each -> !each.isBlank())
            .map(each -> Path.of(each, "lib"))
            .toList();
    return folders.stream()
        .map(each -> each.resolve(LIBRARY))
        .filter(Files::exists)
        .findFirst()
        .map(found -> new Installation(folders, found));
  }

  /** Its {@code rcl}. */
  Path library() {
    return library;
  }

  /**
   * Loads it.
   *
   * @throws RosException if that is not possible, or of no use
   */
  void load() {
    libraries.load(LIBRARY);
    // Those of DDS load one of these by its name only.
    libraries.loadAll("librmw_dds_common__rosidl_typesupport_", ".so");
    if (libraries.find(SINCE_IRON).equals(MemorySegment.NULL))
      throw new RosException(library + " is older than ROS 2 Iron, the first that can be used");
  }

  /**
   * Loads what there is of the types of a package.
   *
   * @throws RosException if there is nothing
   */
  void loadTypes(String pack) {
    String main = "lib" + pack + "__rosidl_typesupport_c.so";
    if (folders.stream().noneMatch(each -> Files.exists(each.resolve(main))))
      throw new RosException(
          "the installed ROS 2 has nothing of the package "
              + pack
              + ": build it there, or set URBI_ROS_MIDDLEWARE=embedded");
    libraries.load(main);
    // The middleware loads one of these by its name only.
    libraries.loadAll("lib" + pack + "__rosidl_typesupport_", "_c.so");
  }

  CFunctions functions() {
    return functions;
  }
}
