package org.urbi.tests;

import static com.tngtech.archunit.lang.SimpleConditionEvent.violated;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static java.util.Map.entry;

import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.ConditionEvents;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * The order of the packages: each knows only those that stand before its own in the list of its
 * module. Which module knows which is said by the poms, and by {@link ArchitectureTest}.
 */
final class RoomOrder {
  private RoomOrder() {}

  private static List<String> below(String top, String... packages) {
    return Stream.of(packages).map(name -> top + name).toList();
  }

  /** The packages of each module, from the bottom to the top. */
  static final Map<String, List<String>> MODULES =
      Map.ofEntries(
          entry(
              "urbi-lang",
              below(
                  "org.urbi.lang",
                  ".problem",
                  ".source",
                  ".ast",
                  ".grammar",
                  ".highlight",
                  ".print",
                  ".text",
                  ".parse",
                  ".advice",
                  ".input")),
          entry("urbi-builtins", List.of("org.urbi.builtins")),
          entry(
              "uobject-java",
              List.of(
                  "urbi.media",
                  "urbi.time",
                  "urbi.thread",
                  "com.sun.image.codec.jpeg",
                  "urbi",
                  "liburbi.main",
                  "urbi.spi",
                  "urbi.wire",
                  "urbi.rtp",
                  "urbi.remote")),
          entry(
              "urbi-kernel",
              below(
                  "org.urbi.kernel",
                  ".time",
                  ".trust",
                  ".object",
                  ".error",
                  ".budget",
                  ".log",
                  ".message",
                  ".journal",
                  ".job",
                  ".outside",
                  ".memory",
                  ".node",
                  ".tier",
                  ".builtin",
                  ".event",
                  ".tag",
                  ".compile",
                  ".lobby",
                  ".variable",
                  ".uobject",
                  ".remote",
                  ".external",
                  ".library.value",
                  ".library.lobby",
                  ".library.reference",
                  ".library.text",
                  ".library.collection",
                  ".library.math",
                  ".library.date",
                  ".library.file",
                  ".library.object",
                  ".library.code",
                  ".library.exception",
                  ".library.machine",
                  ".library.concurrent",
                  ".library.motion",
                  ".library.system",
                  ".library.uobject",
                  ".library",
                  ".observe",
                  ".embed",
                  "",
                  ".script")),
          entry("uobject-native-bridge", List.of("org.urbi.bridge")),
          entry(
              "sim-devices",
              Stream.concat(
                      Stream.of("org.opencv.core"),
                      below(
                          "org.urbi.sim",
                          "",
                          ".time",
                          ".geometry",
                          ".physics",
                          ".render",
                          ".physics.ode",
                          ".physics.ode4j",
                          ".vision",
                          ".world",
                          ".page",
                          ".device")
                          .stream())
                  .toList()),
          entry(
              "urbi-ros",
              below(
                  "org.urbi.ros",
                  ".message",
                  ".time",
                  ".codec",
                  ".graph",
                  ".net",
                  ".rtps",
                  ".bridge",
                  ".frames",
                  ".one",
                  ".two",
                  ".rcl",
                  ".uobject")),
          entry("urbi-web", List.of("org.urbi.web")),
          entry("urbi-site", List.of("org.urbi.site")),
          entry(
              "urbi-server",
              below(
                  "org.urbi.server",
                  "",
                  ".options",
                  ".make",
                  ".source",
                  ".trust",
                  ".console",
                  ".net",
                  ".isolated",
                  ".tools",
                  ".studio.files",
                  ".studio.access",
                  ".studio.messages",
                  ".studio.foxglove",
                  ".studio.mcap",
                  ".studio",
                  ".cli",
                  ".launch",
                  ".manual")),
          entry(
              "bench",
              below(
                  "org.urbi.bench",
                  "",
                  ".clients",
                  ".crossing",
                  ".jmh",
                  ".remote",
                  ".ros",
                  ".sim",
                  ".soak")));

  /** The place of each package in the order of its module. */
  private static final Map<String, Place> PLACES = new TreeMap<>();

  private record Place(String module, int height) {}

  static {
    MODULES.forEach((module, packages) -> {
      for (int height = 0; height < packages.size(); height++) {
        PLACES.put(packages.get(height), new Place(module, height));
      }
    });
  }

  @ArchTest
  static final ArchRule eachPackageKnowsThoseBeforeItsOwn =
      classes()
          .should(
              new ArchCondition<JavaClass>("know only the packages that stand before their own") {
                @Override
                public void check(JavaClass type, ConditionEvents events) {
                  Place own = PLACES.get(type.getPackageName());
                  if (own == null) {
                    events.add(violated(type, type.getName() + " is in a package without a place"));
                    return;
                  }
                  for (Dependency dependency : type.getDirectDependenciesFromSelf()) {
                    Place other = PLACES.get(dependency.getTargetClass().getPackageName());
                    if (other != null
                        && other.module().equals(own.module())
                        && other.height() > own.height()) {
                      events.add(violated(type, dependency.getDescription()));
                    }
                  }
                }
              });
}
