package org.urbi.tests;

import static com.tngtech.archunit.lang.conditions.ArchPredicates.are;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static java.util.Map.entry;

import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import java.lang.reflect.Method;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletionStage;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Threads are made in two places, which log what ends one and tell who depends on it: {@code
 * GuardedThreads}, and {@code NetworkLoop} for those of Netty. Nothing ends in silence, nor does
 * what streams do with answers that come later.
 */
final class ThreadLaw {
  private ThreadLaw() {}

  /** Classes, and the names of their methods that make threads; empty for all of them. */
  private static final Map<String, Set<String>> MAKERS =
      Map.ofEntries(
          entry(
              "java.lang.Thread",
              Set.of("<init>", "startVirtualThread", "ofPlatform", "ofVirtual")),
          entry("java.util.concurrent.Executors", Set.of()),
          entry("java.util.concurrent.ForkJoinPool", Set.of("<init>")),
          entry("java.util.concurrent.ScheduledThreadPoolExecutor", Set.of("<init>")),
          entry("java.util.concurrent.ThreadPoolExecutor", Set.of("<init>")),
          entry("java.util.Timer", Set.of("<init>")),
          entry("io.netty.channel.MultiThreadIoEventLoopGroup", Set.of("<init>")),
          entry("io.netty.channel.SingleThreadIoEventLoop", Set.of("<init>")),
          entry("io.netty.util.concurrent.DefaultThreadFactory", Set.of("<init>")));

  @ArchTest
  static final ArchRule threadsAreMadeWhereTheyAreGuarded =
      noClasses()
          .that()
          .resideOutsideOfPackage("org.urbi.bench..")
          .and()
          .haveNameNotMatching("urbi\\.thread\\.GuardedThreads(\\$.*)?")
          .and()
          .haveNameNotMatching("org\\.urbi\\.web\\.NetworkLoop(\\$.*)?")
          .and()
          // They run the jobs and the tick loop, which see to what is thrown in them themselves.
          .haveNameNotMatching("org\\.urbi\\.kernel\\.job\\.(HandoffThread|TickLoopThread)(\\$.*)?")
          .and()
          // It guards its thread, which inherits nothing of the program that makes the kernel.
          .doNotHaveFullyQualifiedName("org.urbi.kernel.memory.MemoryWatchdog")
          .should()
          .accessTargetWhere(are(ArchitectureTest.callsOf("what makes threads", MAKERS)));

  /** What one of these throws is kept in a stage that nobody asks, or logged by Netty at most. */
  private static final Map<String, Set<String>> LATER =
      Map.of(
          "java.util.concurrent.CompletableFuture",
          Stream.of(CompletionStage.class.getMethods())
              .map(Method::getName)
              .filter(name -> !name.equals("toCompletableFuture"))
              .collect(Collectors.toSet()));

  @ArchTest
  static final ArchRule streamsDoLaterWhatIsGuarded =
      noClasses()
          .that()
          .resideInAnyPackage("org.urbi.server.studio..", "org.urbi.web..", "org.urbi.sim.page..")
          .and()
          .doNotHaveFullyQualifiedName("org.urbi.server.studio.access.LateAnswers")
          .should()
          .accessTargetWhere(are(ArchitectureTest.callsOf("what is done later", LATER)));
}
