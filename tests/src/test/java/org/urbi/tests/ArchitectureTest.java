package org.urbi.tests;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.conditions.ArchPredicates.are;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static java.util.Map.entry;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.AccessTarget;
import com.tngtech.archunit.core.domain.AccessTarget.CodeUnitCallTarget;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaCall;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.core.importer.ImportOption.DoNotIncludeTests;
import com.tngtech.archunit.core.importer.Location;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.junit.ArchTests;
import com.tngtech.archunit.junit.CacheMode;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.lang.SimpleConditionEvent;
import com.tngtech.archunit.library.dependencies.SliceAssignment;
import com.tngtech.archunit.library.dependencies.SliceIdentifier;
import java.lang.reflect.RecordComponent;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.urbi.kernel.job.Inbox;
import org.urbi.kernel.message.Data;
import org.urbi.kernel.message.Message;
import urbi.UValue;

/**
 * Which package may depend on which. Maven checks the dependencies of modules; this test checks
 * those of packages, and what no pom can express: where the clock is read, where random numbers are
 * drawn, and which package uses which library.
 */
@AnalyzeClasses(
    packages = {"org.urbi", "urbi", "liburbi", "com.sun.image.codec.jpeg", "org.opencv.core"},
    importOptions = {DoNotIncludeTests.class, ArchitectureTest.NotOpenCv.class},
    // Every collection of garbage would look at 170 MB of them, and some suites collect a lot.
    cacheMode = CacheMode.PER_CLASS)
class ArchitectureTest {
  /** One class of ours is in a package of that library; it has some hundred of its own there. */
  static final class NotOpenCv implements ImportOption {
    @Override
    public boolean includes(Location location) {
      return !location.matches(Pattern.compile(".*/opencv-[^/]*\\.jar.*"));
    }
  }

  private static final DescribedPredicate<JavaClass> OURS =
      resideInAnyPackage("org.urbi..", "urbi..", "liburbi..", "com.sun.image.codec.jpeg");

  @ArchTest static final ArchTests orderOfPackages = ArchTests.in(RoomOrder.class);

  @ArchTest static final ArchTests makersOfThreads = ArchTests.in(ThreadLaw.class);

  @ArchTest static final ArchTests endOfFailures = ArchTests.in(CatchLaw.class);

  @ArchTest static final ArchTests firstSecond = ArchTests.in(StartLaw.class);

  private static ArchRule dependsOnlyOn(String packageName, String... others) {
    return classes()
        .that()
        .resideInAPackage(packageName)
        .should()
        .onlyDependOnClassesThat(
            DescribedPredicate.not(OURS)
                .or(resideInAPackage(packageName))
                .or(resideInAnyPackage(others)));
  }

  @ArchTest static final ArchRule languageDependsOnNothingElse = dependsOnlyOn("org.urbi.lang..");

  @ArchTest
  static final ArchRule builtinsDependOnNothingElse = dependsOnlyOn("org.urbi.builtins..");

  @ArchTest
  static final ArchRule kernelDependsOnLanguageAndBuiltins =
      dependsOnlyOn("org.urbi.kernel..", "org.urbi.lang..", "org.urbi.builtins..", "urbi..");

  @ArchTest
  static final ArchRule sdkNeedsNoOtherJar =
      classes()
          .that()
          .resideInAPackage("urbi..")
          .should()
          .onlyDependOnClassesThat()
          // Of the JDK alone: TLS, windows and sounds for those who use them.
          .resideInAnyPackage(
              "urbi..",
              "java..",
              "javax.imageio..",
              "javax.net..",
              "javax.swing..",
              "javax.sound.sampled..",
              "org.jspecify.annotations..");

  @ArchTest static final ArchRule timeDependsOnNothingElse = dependsOnlyOn("urbi.time");

  @ArchTest static final ArchRule threadsDependOnNothingElse = dependsOnlyOn("urbi.thread");

  @ArchTest static final ArchRule mediaDependsOnNothingElse = dependsOnlyOn("urbi.media");

  @ArchTest
  static final ArchRule publicApiDependsOnLowerPackages =
      dependsOnlyOn("urbi", "urbi.time", "urbi.thread", "urbi.media");

  @ArchTest
  static final ArchRule spiDependsOnTheSdkOnly = dependsOnlyOn("urbi.spi", "urbi.thread", "urbi");

  @ArchTest static final ArchRule wireDependsOnValues = dependsOnlyOn("urbi.wire", "urbi");

  @ArchTest
  static final ArchRule rtpDependsOnValuesAndWire = dependsOnlyOn("urbi.rtp", "urbi.wire", "urbi");

  @ArchTest
  static final ArchRule sdkDoesNotDependOnRemoteProcesses =
      noClasses()
          .that()
          .resideInAPackage("urbi..")
          .and()
          .resideOutsideOfPackage("urbi.remote..")
          .should()
          .dependOnClassesThat()
          .resideInAPackage("urbi.remote..");

  @ArchTest
  static final ArchRule simulationDependsOnTheSdkAndItsPage =
      dependsOnlyOn("org.urbi.sim..", "org.urbi.web", "urbi");

  @ArchTest static final ArchRule pagesDependOnNothingElse = dependsOnlyOn("org.urbi.web");

  @ArchTest
  static final ArchRule theSiteDependsOnColours =
      dependsOnlyOn("org.urbi.site", "org.urbi.lang.highlight");

  @ArchTest
  static final ArchRule rosDependsOnTheSdkOnly =
      dependsOnlyOn("org.urbi.ros..", "urbi.thread", "urbi");

  @ArchTest
  static final ArchRule rosMessagesDependOnValuesOnly =
      dependsOnlyOn("org.urbi.ros.message..", "urbi");

  @ArchTest
  static final ArchRule rosCodecDependsOnMessages =
      dependsOnlyOn("org.urbi.ros.codec..", "org.urbi.ros.message..", "urbi");

  @ArchTest
  static final ArchRule rosGraphDependsOnMessages =
      dependsOnlyOn("org.urbi.ros.graph..", "org.urbi.ros.message..", "urbi.thread", "urbi");

  @ArchTest
  static final ArchRule rosNetDependsOnNothingElseOfRos =
      dependsOnlyOn("org.urbi.ros.net", "urbi.thread", "urbi");

  @ArchTest
  static final ArchRule rosOneDependsOnTheGraph =
      dependsOnlyOn(
          "org.urbi.ros.one..",
          "org.urbi.ros.graph..",
          "org.urbi.ros.codec..",
          "org.urbi.ros.message..",
          "org.urbi.ros.net",
          "org.urbi.ros.time",
          "urbi.thread",
          "urbi");

  @ArchTest
  static final ArchRule rosInstallationsAreNotKnownToNodesOfOurOwn =
      noClasses()
          .that()
          .resideInAnyPackage("org.urbi.ros.two..", "org.urbi.ros.rtps..")
          .should()
          .dependOnClassesThat()
          .resideInAPackage("org.urbi.ros.rcl..");

  @ArchTest
  static final ArchRule rosBridgeDependsOnTheGraph =
      dependsOnlyOn(
          "org.urbi.ros.bridge..",
          "org.urbi.ros.graph..",
          "org.urbi.ros.message..",
          "org.urbi.ros.net",
          "org.urbi.ros.time",
          "urbi.thread",
          "urbi");

  @ArchTest
  static final ArchRule rosFramesDependOnTheGraph =
      dependsOnlyOn(
          "org.urbi.ros.frames..", "org.urbi.ros.graph..", "org.urbi.ros.message..", "urbi");

  @ArchTest
  static final ArchRule nothingOfRosDependsOnItsObjects =
      noClasses()
          .that()
          .resideInAPackage("org.urbi.ros..")
          .and()
          .resideOutsideOfPackage("org.urbi.ros.uobject..")
          .should()
          .dependOnClassesThat()
          .resideInAPackage("org.urbi.ros.uobject..");

  private static ArchRule onlyIn(String packageName, String library) {
    return noClasses()
        .that()
        .resideInAPackage("org.urbi..")
        .and()
        .resideOutsideOfPackage(packageName)
        .should()
        .dependOnClassesThat()
        .resideInAPackage(library);
  }

  @ArchTest
  static final ArchRule antlrIsUsedInTheLanguageOnly = onlyIn("org.urbi.lang..", "org.antlr..");

  @ArchTest
  static final ArchRule commonmarkIsUsedInTheSiteOnly = onlyIn("org.urbi.site", "org.commonmark..");

  @ArchTest
  static final ArchRule nettyIsUsedInTheNetworkAndForPagesOnly =
      noClasses()
          .that()
          .resideInAPackage("org.urbi..")
          .and()
          .resideOutsideOfPackages(
              "org.urbi.server.net..",
              "org.urbi.server.studio..",
              "org.urbi.sim.page..",
              "org.urbi.web")
          .should()
          .dependOnClassesThat()
          .resideInAPackage("io.netty..");

  @ArchTest
  static final ArchRule jacksonIsUsedInTheStudioOnly =
      onlyIn("org.urbi.server.studio..", "com.fasterxml..");

  @ArchTest
  static final ArchRule jlineIsUsedInTheConsoleOnly =
      onlyIn("org.urbi.server.console..", "org.jline..");

  @ArchTest
  static final ArchRule picocliIsUsedInOptionsOnly =
      onlyIn("org.urbi.server.options..", "picocli..");

  @ArchTest
  static final ArchRule ode4jIsUsedInItsEngineOnly =
      onlyIn("org.urbi.sim.physics.ode4j..", "org.ode4j..");

  @ArchTest
  static final ArchRule opencvIsUsedInVisionOnly = onlyIn("org.urbi.sim.vision..", "org.opencv..");

  /** Class and the names of its methods that read the time of the machine. */
  private static final Map<String, Set<String>> CLOCKS =
      Map.ofEntries(
          entry("java.lang.System", Set.of("nanoTime", "currentTimeMillis")),
          entry("java.time.Instant", Set.of("now")),
          entry("java.time.LocalDate", Set.of("now")),
          entry("java.time.LocalDateTime", Set.of("now")),
          entry("java.time.LocalTime", Set.of("now")),
          entry("java.time.OffsetDateTime", Set.of("now")),
          entry("java.time.OffsetTime", Set.of("now")),
          entry("java.time.Year", Set.of("now")),
          entry("java.time.YearMonth", Set.of("now")),
          entry("java.time.MonthDay", Set.of("now")),
          entry("java.time.ZonedDateTime", Set.of("now")),
          entry(
              "java.time.Clock",
              Set.of(
                  "systemUTC",
                  "systemDefaultZone",
                  "system",
                  "tick",
                  "tickMillis",
                  "tickSeconds",
                  "tickMinutes")),
          entry("java.time.InstantSource", Set.of("system")),
          entry("io.netty.util.concurrent.Ticker", Set.of("nanoTime", "systemTicker")),
          entry("java.util.Calendar", Set.of("getInstance")),
          entry("java.util.GregorianCalendar", Set.of("<init>")),
          entry("java.util.Date", Set.of("<init>")));

  private static final Map<String, Set<String>> DICE =
      Map.of(
          "java.lang.Math", Set.of("random"),
          "java.util.Random", Set.of("<init>"),
          "java.util.SplittableRandom", Set.of("<init>"),
          "java.security.SecureRandom", Set.of("<init>"),
          "java.util.concurrent.ThreadLocalRandom", Set.of("current"),
          "java.util.random.RandomGenerator", Set.of("getDefault", "of"),
          "java.util.UUID", Set.of("randomUUID"));

  @ArchTest
  static final ArchRule onlyTheTimePackageReadsTheClock =
      noClasses()
          .that()
          .resideInAnyPackage("org.urbi..", "urbi..", "liburbi..", "com.sun..", "org.opencv..")
          .and()
          .resideOutsideOfPackages(
              "org.urbi.kernel.time..",
              "org.urbi.sim.time..",
              "org.urbi.ros.time..",
              "org.urbi.bench..",
              "urbi.time")
          .and()
          // How long a process is silent is measured by the clock of the event loop, whose timers
          // look at that; tests give the loop another one.
          .doNotHaveFullyQualifiedName("org.urbi.server.net.FrameHandler")
          .and()
          // Datagrams are timed by the same clock.
          .doNotHaveFullyQualifiedName("org.urbi.server.net.FrameDatagrams")
          .should()
          .accessTargetWhere(are(callsOf("a clock", CLOCKS)));

  @ArchTest
  static final ArchRule onlyTheRandomPackageDrawsNumbers =
      noClasses()
          .that()
          .resideInAnyPackage("org.urbi..", "urbi..")
          .and()
          .resideOutsideOfPackage("org.urbi.bench..")
          .and()
          // Their secrets are for the one at the other end, and must not be guessed from a seed.
          .doNotHaveFullyQualifiedName("org.urbi.server.net.FrameDatagrams")
          .and()
          .doNotHaveFullyQualifiedName("org.urbi.web.Downloads")
          .and()
          .haveNameNotMatching("org\\.urbi\\.server\\.net\\.ModuleNetwork(\\$.*)?")
          .and()
          .haveNameNotMatching("urbi\\.remote\\.RemoteDatagrams(\\$.*)?")
          .and()
          // Nothing that a program can see depends on its secret, which must not be guessed either.
          .doNotHaveFullyQualifiedName("org.urbi.kernel.object.EntryTable")
          .should()
          .accessTargetWhere(are(callsOf("a source of random numbers", DICE)));

  /** Files, processes and connections: what a kernel may be kept away from. */
  private static final DescribedPredicate<JavaClass> MACHINE =
      new DescribedPredicate<>("files, processes or connections") {
        private static final Pattern NAMES =
            Pattern.compile(
                "java\\.nio\\.file\\.(Files|FileSystems?|WatchService|DirectoryStream|FileVisitor)"
                    + "|java\\.nio\\.channels\\..*"
                    + "|java\\.io\\.(File|FileInputStream|FileOutputStream|FileReader|FileWriter"
                    + "|RandomAccessFile)"
                    + "|java\\.lang\\.(Process|ProcessBuilder|ProcessHandle|Runtime)"
                    + "|java\\.net\\.(Socket|ServerSocket|DatagramSocket|MulticastSocket|URL|URI"
                    + "|URLConnection|NetworkInterface|http\\..*)"
                    + "|java\\.util\\.(zip\\.ZipFile|jar\\.JarFile|Scanner|logging\\..*)"
                    + "|javax\\.net\\..*");

        @Override
        public boolean test(JavaClass used) {
          return NAMES.matcher(used.getName()).matches();
        }
      };

  private static final Map<String, Set<String>> MACHINE_CALLS =
      Map.of(
          "java.nio.file.Path", Set.of("toRealPath", "toFile", "register"),
          "java.net.InetAddress",
              Set.of(
                  "getByName",
                  "getAllByName",
                  "getLocalHost",
                  "getHostName",
                  "getCanonicalHostName",
                  "isReachable"),
          "java.net.InetSocketAddress", Set.of("<init>", "getHostName"),
          "java.lang.System", Set.of("load", "loadLibrary", "exit", "setProperty"));

  @ArchTest
  static final ArchRule onlyTheOutsidePackageAccessesTheMachine =
      noClasses()
          .that()
          .resideInAPackage("org.urbi.kernel..")
          .and()
          .resideOutsideOfPackage("org.urbi.kernel.outside..")
          .and()
          // It makes addresses of their numbers, and looks nothing up.
          .doNotHaveFullyQualifiedName("org.urbi.kernel.journal.DataReader")
          .should()
          .dependOnClassesThat(MACHINE)
          .orShould()
          .accessTargetWhere(are(callsOf("the machine", MACHINE_CALLS)));

  private static final Map<String, Set<String>> SETTINGS =
      Map.of(
          "java.lang.System", Set.of("getProperty", "getProperties", "getenv"),
          "java.lang.Integer", Set.of("getInteger"),
          "java.lang.Long", Set.of("getLong"),
          "java.lang.Boolean", Set.of("getBoolean"));

  /** On another machine they are others: what urbiscript sees of them passes the journal. */
  @ArchTest
  static final ArchRule onlyTheOutsidePackageReadsSettings =
      noClasses()
          .that()
          .resideInAPackage("org.urbi.kernel..")
          .and()
          .resideOutsideOfPackage("org.urbi.kernel.outside..")
          .and()
          // Before there is a journal, of the level of the log; a recording begins with it.
          .doNotHaveFullyQualifiedName("org.urbi.kernel.KernelBuilder")
          .and()
          // Compiled code or not makes no difference to a run.
          .doNotHaveFullyQualifiedName("org.urbi.kernel.TierSetting")
          .should()
          .accessTargetWhere(are(callsOf("settings of the machine", SETTINGS)));

  /** Calls that take whatever character set the machine happens to have. */
  private static final Map<String, List<List<String>>> DEFAULT_CHARSETS =
      Map.ofEntries(
          entry("java.lang.String.<init>", List.of(List.of("[B"), List.of("[B", "int", "int"))),
          entry("java.lang.String.getBytes", List.of(List.of())),
          entry("java.io.InputStreamReader.<init>", List.of(List.of("java.io.InputStream"))),
          entry("java.io.OutputStreamWriter.<init>", List.of(List.of("java.io.OutputStream"))),
          entry(
              "java.io.FileReader.<init>",
              List.of(List.of("java.lang.String"), List.of("java.io.File"))),
          entry(
              "java.io.FileWriter.<init>",
              List.of(List.of("java.lang.String"), List.of("java.io.File"))),
          entry(
              "java.io.PrintStream.<init>",
              List.of(List.of("java.io.OutputStream"), List.of("java.io.OutputStream", "boolean"))),
          entry(
              "java.io.PrintWriter.<init>",
              List.of(List.of("java.io.OutputStream"), List.of("java.io.OutputStream", "boolean"))),
          entry("java.util.Scanner.<init>", List.of(List.of("java.io.InputStream"))),
          entry("java.io.ByteArrayOutputStream.toString", List.of(List.of())),
          entry("java.nio.charset.Charset.defaultCharset", List.of(List.of())));

  @ArchTest
  static final ArchRule theMachinesCharacterSetDoesNotMatter =
      noClasses()
          .that()
          .resideInAnyPackage("org.urbi..", "urbi..", "liburbi..", "com.sun..", "org.opencv..")
          .should()
          .callCodeUnitWhere(
              new DescribedPredicate<JavaCall<?>>("uses the default character set") {
                @Override
                public boolean test(JavaCall<?> call) {
                  CodeUnitCallTarget target = call.getTarget();
                  String name = target.getOwner().getName() + "." + target.getName();
                  List<String> parameters =
                      target.getRawParameterTypes().stream().map(JavaClass::getName).toList();
                  return DEFAULT_CHARSETS.getOrDefault(name, List.of()).contains(parameters);
                }
              });

  /** Every package by itself, whatever module it belongs to. */
  @ArchTest
  static final ArchRule noCyclesAmongPackages =
      slices()
          .assignedFrom(
              new SliceAssignment() {
                @Override
                public SliceIdentifier getIdentifierOf(JavaClass type) {
                  return OURS.test(type)
                      ? SliceIdentifier.of(type.getPackageName())
                      : SliceIdentifier.ignore();
                }

                @Override
                public String getDescription() {
                  return "the packages of all modules";
                }
              })
          .should()
          .beFreeOfCycles();

  @ArchTest
  static final ArchRule noCyclesAmongPackagesOfTheLanguage =
      slices().matching("org.urbi.lang.(*)..").should().beFreeOfCycles();

  @ArchTest
  static final ArchRule noCyclesAmongPackagesOfTheKernel =
      slices().matching("org.urbi.kernel.(*)..").should().beFreeOfCycles();

  @ArchTest
  static final ArchRule noCyclesAmongPackagesOfTheLibrary =
      slices().matching("org.urbi.kernel.library.(*)..").should().beFreeOfCycles();

  @ArchTest
  static final ArchRule noCyclesAmongPackagesOfTheSimulation =
      slices().matching("org.urbi.sim.(*)..").should().beFreeOfCycles();

  @ArchTest
  static final ArchRule noCyclesAmongPackagesOfTheServer =
      slices().matching("org.urbi.server.(*)..").should().beFreeOfCycles();

  @ArchTest
  static final ArchRule onlyOutsideCodePostsMessages =
      noClasses()
          .that()
          .resideOutsideOfPackages(
              "org.urbi.kernel",
              "org.urbi.kernel.job",
              "org.urbi.kernel.embed",
              "org.urbi.kernel.outside",
              "org.urbi.kernel.remote",
              "org.urbi.kernel.uobject")
          .should()
          .callMethod(Inbox.class, "post", Message.class);

  /** What passes the inbox is data: it can be written down, and read again in another process. */
  @ArchTest
  static final ArchRule messagesAreData =
      classes()
          .that()
          .implement(Message.class)
          .should(
              new ArchCondition<>("be records of data") {
                private static final Set<Class<?>> DATA =
                    Set.of(
                        int.class,
                        long.class,
                        boolean.class,
                        String.class,
                        byte[].class,
                        InetSocketAddress.class,
                        Message.class,
                        UValue.class,
                        UValue[].class,
                        Data.class,
                        // What it says is written; what it is, stays with whoever waits for it.
                        Throwable.class);

                @Override
                public void check(JavaClass message, ConditionEvents events) {
                  Class<?> type = message.reflect();
                  boolean data = type.isInterface() ? type.isSealed() : isRecord(type);
                  events.add(new SimpleConditionEvent(message, data, type + " is data: " + data));
                }

                private boolean isRecord(Class<?> type) {
                  return type.isRecord()
                      && Stream.of(type.getRecordComponents())
                          .map(RecordComponent::getType)
                          .allMatch(this::isData);
                }

                private boolean isData(Class<?> type) {
                  return DATA.contains(type)
                      || type.isEnum()
                      || type.isSealed()
                          && Stream.of(type.getPermittedSubclasses()).allMatch(this::isRecord);
                }
              });

  /**
   * Calls, and references to methods that somebody else calls.
   *
   * @param forbidden classes, and the names of their methods; empty for all of them
   */
  static DescribedPredicate<JavaAccess<?>> callsOf(
      String what, Map<String, Set<String>> forbidden) {
    return new DescribedPredicate<>("calls of " + what) {
      @Override
      public boolean test(JavaAccess<?> access) {
        AccessTarget target = access.getTarget();
        Set<String> names = forbidden.get(target.getOwner().getName());
        return names != null && (names.isEmpty() || names.contains(target.getName()));
      }
    };
  }
}
