package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.job.Turn;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.observe.JobRow;
import org.urbi.kernel.observe.Steering.Action;
import org.urbi.kernel.observe.TagRow;
import org.urbi.kernel.observe.View;
import org.urbi.kernel.observe.ViewRequest;
import org.urbi.kernel.trust.Role;

/** Somebody looks at the jobs and tags of a running kernel, and controls them. */
class JobViewTest {
  private Kernel kernel;
  private TestClient program;
  private Viewer owner;

  @BeforeEach
  void start() {
    kernel = Kernel.builder().log(line -> {}).start();
    program = new TestClient(kernel, Role.OWNER);
    owner = new Viewer(kernel, Role.OWNER);
  }

  @AfterEach
  void stop() {
    assertEquals("3", program.say("1 + 2;"));
    kernel.close();
  }

  @Test
  void tellsWhatJobsWaitForAndWhere() {
    program.say(
        """
        var Global.e = Event.new|; var Global.x = 0|; var Global.m = Mutex.new|;
        myTime: sleep(1h),
        myPeriod: every (1h) 1,
        myEvent: waituntil (e?),
        myCondition: waituntil (x == 1),
        myFile: { var p = Process.new("cat", []); p.run(); p.join() },
        m: sleep(1h),
        myLock: { sleep(1ms); m: 1 },
        myBoth: { sleep(1h) & sleep(1h) },
        myBusy: loop { 1 },
        """);
    assertEquals("time", owner.under("myTime").waits());
    long file = owner.tag("myFile").number();
    owner.await(row -> row.tags().contains(file) && row.waits().equals("file"));
    assertEquals("time", owner.under("myPeriod").waits());
    assertEquals("event", owner.under("myEvent").waits());
    assertEquals("condition", owner.under("myCondition").waits());
    long lock = owner.tag("myLock").number();
    owner.await(row -> row.tags().contains(lock) && row.waits().equals("lock"));
    long both = owner.tag("myBoth").number();
    JobRow parent = owner.await(row -> row.tags().contains(both) && row.waits().equals("jobs"));
    assertEquals(
        2, owner.jobs.values().stream().filter(row -> row.starter() == parent.number()).count());
    JobRow busy = owner.under("myBusy");
    assertEquals("running", busy.waits());
    owner.await(row -> row.number() == busy.number() && row.share() > 100);
    assertTrue(owner.under("myEvent").place().matches("\\d+\\.\\d+-\\d+"), busy.place());
    assertTrue(busy.lobby().startsWith("Lobby_"), busy.lobby());
  }

  @Test
  void showsCallsWithTheirLines() {
    program.say(
        """
        function Global.outer() { inner() }|;
        function Global.inner() { sleep(1h) }|;
        deep: outer(),
        """);
    JobRow job = owner.under("deep");
    owner.look(new ViewRequest(job.number(), List.of(), null, null));
    assertNotNull(owner.last.detail());
    assertTrue(owner.last.detail().left() > 3000, "it waits for an hour");
    List<String> names = owner.last.detail().calls().stream().map(call -> call.name()).toList();
    assertTrue(names.containsAll(List.of("inner", "outer")), names.toString());
    assertTrue(
        owner.last.detail().calls().getFirst().line().contains("sleep(1h)"),
        owner.last.detail().toString());
  }

  @Test
  void turnsOfTracedJobsAreKept() {
    program.say("ticks: every| (1ms) { 1 },");
    JobRow job = owner.under("ticks");
    ViewRequest wanted = new ViewRequest(0, List.of(job.number()), null, null);
    List<Turn> turns;
    do {
      turns = owner.look(wanted).last.turns().turns();
    } while (turns.stream().noneMatch(turn -> turn.before() == Wait.TIME));
    // Who made the job runnable before anybody looked is not known.
    for (Turn turn : turns.stream().dropWhile(each -> each.before() != Wait.TIME).toList()) {
      assertEquals(job.number(), turn.job());
      // A turn that is late is followed by the next one at once.
      assertEquals(
          turn.before() == Wait.TIME ? 0L : job.number(),
          turn.wakers().isEmpty() ? 0L : turn.wakers().getFirst());
      assertTrue(turn.begin() <= turn.end());
    }
  }

  /** Jobs of an {@code at}, and of the turns of an {@code every}, are over before anybody asks. */
  @Test
  void firstTurnsOfNewJobsAreKeptAndWhoHasStartedTheirWakers() {
    program.say(
        """
        var Global.e = Event.new|; var Global.f = Event.new|;
        at (e?) reacting: { sleep(2ms)| f! };
        listening: loop { waituntil (f?); sleep(1ms) },
        beating: every (20ms) e!,
        """);
    long beating = owner.under("beating").number();
    long listening = owner.under("listening").number();
    ViewRequest wanted = new ViewRequest(0, List.of(listening), null, null);
    List<Turn> turns = new ArrayList<>();
    Predicate<Turn> wakes = turn -> turn.job() == listening && turn.wakers().contains(beating);
    while (turns.stream().noneMatch(wakes)) {
      turns.addAll(owner.look(wanted).last.turns().turns());
    }
    Turn woken = turns.stream().filter(wakes).findFirst().orElseThrow();
    assertEquals(Wait.EVENT, woken.before());
    long reacting = woken.wakers().getFirst();
    List<Turn> reaction = turns.stream().filter(turn -> turn.job() == reacting).toList();
    assertEquals(2, reaction.size(), () -> "before it sleeps, and after that: " + reaction);
    assertEquals(woken.wakers().subList(1, 3), reaction.getFirst().wakers().subList(0, 2));
    assertEquals(List.of(), reaction.getLast().wakers(), "the time has woken it");
    assertTrue(reaction.getLast().ended());
  }

  /** Those that are to be looked at must not lose their turns to very many new ones. */
  @Test
  void onlyFewNewJobsAreTracedAtOnce() {
    program.say("ticks: every| (1ms) { 1 },");
    long ticks = owner.under("ticks").number();
    ViewRequest wanted = new ViewRequest(0, List.of(ticks), null, null);
    owner.look(wanted);
    program.say("for& (10000) { ; 1; 2 };");
    List<Turn> turns = owner.look(wanted).last.turns().turns();
    long others = turns.stream().map(Turn::job).filter(job -> job != ticks).distinct().count();
    assertTrue(others > 0 && others <= 64, others + " new jobs");
    assertTrue(turns.stream().anyMatch(turn -> turn.job() == ticks), "and the one that is traced");
  }

  /** Nobody must take the time in which he has not looked for one in which a job has waited. */
  @Test
  void sinceWhenTheTurnsOfEachJobAreToldIsTold() {
    program.say("ticks: every| (1ms) { 1 }, tocks: every| (1ms) { 1 },");
    long ticks = owner.under("ticks").number();
    long tocks = owner.under("tocks").number();
    long one = since(ticks, ticks);
    assertTrue(one >= owner.last.machine(), "from now on");
    assertNull(owner.look(looking(ticks)).last.turns().traced(), "that has not changed");
    Map<Long, Long> both = traced(looking(ticks, tocks));
    assertEquals(one, both.get(ticks), "it has been traced without a break");
    assertTrue(both.get(tocks) > one);
    assertEquals(Map.of(tocks, both.get(tocks)), traced(looking(tocks)));
    long away = owner.last.machine();
    assertTrue(since(ticks, tocks, ticks) > away, "there was a break");
    Viewer other = new Viewer(kernel, Role.OWNER);
    other.look(looking(tocks));
    assertTrue(other.last.turns().traced().get(tocks) >= other.last.machine(), "others have not");
    assertEquals(Map.of(), traced(looking()));
    program.say("late: sleep(1h),");
    long late = owner.under("late").number();
    long then = owner.last.machine();
    assertTrue(since(late, late) > then, "its first turn was not told to who did not look");
    program.say("later: sleep(1h),");
    Predicate<JobRow> isNew = row -> row.number() > late && row.waits().equals("time");
    while (owner.look(looking(late)).jobs.values().stream().noneMatch(isNew)) {
      // It is still being started.
    }
    JobRow born = owner.jobs.values().stream().filter(isNew).findFirst().orElseThrow();
    long seen = owner.last.machine();
    assertTrue(since(born.number(), born.number(), late) < seen, "it was new: all is known of it");
  }

  private static ViewRequest looking(Long... traced) {
    return new ViewRequest(0, List.of(traced), null, null);
  }

  /** What is told of which jobs are traced, as soon as that changes. */
  private Map<Long, Long> traced(ViewRequest wanted) {
    Map<Long, Long> told;
    do {
      told = owner.look(wanted).last.turns().traced();
    } while (told == null);
    return told;
  }

  private long since(long job, Long... traced) {
    return traced(looking(traced)).get(job);
  }

  @Test
  void onlyChangesAreToldOfManyJobs() {
    program.say("many: for& (10000) { sleep(1h) },");
    long many = owner.tag("many").number();
    while (owner.look().jobs.values().stream().filter(r -> r.tags().contains(many)).count()
        < 10_001) {
      // They are still being started.
    }
    while (owner.look().changes >= 20) {
      // They are still on their way to sleep.
    }
    assertEquals(1, owner.views, "views of 10,000 jobs, of which hardly any has changed");
    program.say("many.stop;");
    long latest = System.nanoTime() + TestTimeout.LONG.toNanos();
    while (owner.look().jobs.size() >= 20) {
      assertTrue(System.nanoTime() < latest, () -> owner.jobs.size() + " jobs are left");
    }
  }

  /** A job that is looked at only when it changes must not keep the share of its last turn. */
  @Test
  void whoSleepsAgainHasNoShare() {
    program.say("var Global.e = Event.new|; work: loop { waituntil (e?); for (100000) 1 },");
    long work = owner.under("work").number();
    Viewer other = new Viewer(kernel, Role.OWNER);
    assertEquals(0, other.look().jobs.get(work).share());
    program.say("e!;");
    owner.await(row -> row.number() == work && row.share() > 0);
    owner.await(row -> row.number() == work && row.share() == 0);
    other.await(row -> row.number() == work && row.share() >= 0);
    other.await(row -> row.number() == work && row.share() == 0);
  }

  /** Jobs change that have no turn: their tags do that. Each one who looks is told, in his time. */
  @Test
  void allWhoLookAreToldWhatOthersDoToSleepingJobs() {
    program.say("one: sleep(1h), two: sleep(1h),");
    long one = owner.under("one").number();
    long two = owner.under("two").number();
    Viewer other = new Viewer(kernel, Role.OWNER);
    other.look();
    program.say("one.freeze;");
    assertTrue(owner.look().jobs.get(one).frozen());
    program.say("two.freeze; one.unfreeze;");
    assertTrue(other.look().jobs.get(two).frozen());
    assertTrue(!other.jobs.get(one).frozen() && !owner.look().jobs.get(one).frozen());
    program.say("one.stop;");
    assertTrue(!owner.look().jobs.containsKey(one) && !other.look().jobs.containsKey(one));
    assertTrue(owner.jobs.containsKey(two) && other.jobs.containsKey(two));
  }

  /** What is noted of changes is limited: after that all jobs are looked at again. */
  @Test
  void whoLooksRarelyMissesNothing() {
    program.say("stays: sleep(1h), goes: sleep(1h), freezes: sleep(1h),");
    long stays = owner.under("stays").number();
    long goes = owner.under("goes").number();
    long freezes = owner.under("freezes").number();
    program.say("goes.stop; freezes.freeze; for (2) for& (10000) { sleep(1ms) };");
    owner.look();
    assertTrue(!owner.jobs.containsKey(goes));
    assertTrue(owner.jobs.containsKey(stays) && owner.jobs.get(freezes).frozen());
    program.say("stays.stop;");
    assertTrue(!owner.look().jobs.containsKey(stays));
  }

  @Test
  void tagsAndJobsAreControlled() {
    program.say("var Global.n = 0|; count: every (1ms) { n++ }, other: sleep(1h),");
    TagRow count = owner.tag("count");
    assertEquals("", owner.steer(Action.FREEZE, true, count.number()));
    assertTrue(owner.tag("count").frozen());
    assertTrue(owner.under("count").frozen());
    String before = program.say("n;");
    assertEquals(before, program.say("sleep(20ms); n;"));
    assertEquals("", owner.steer(Action.UNFREEZE, true, count.number()));
    program.say("waituntil (n > " + before + ");");
    assertEquals("", owner.steer(Action.BLOCK, true, count.number()));
    assertTrue(owner.tag("count").blocked(), "it can be unblocked although nothing is under it");
    assertEquals("nothing", program.say("count: echo(1); echo(\"nothing\");").substring(4));
    assertEquals("", owner.steer(Action.UNBLOCK, true, count.number()));
    assertEquals("*** 1", program.say("count: echo(1);"));
    JobRow other = owner.under("other");
    assertEquals("", owner.steer(Action.FREEZE, false, other.number()));
    owner.await(row -> row.number() == other.number() && row.frozen());
    assertEquals("", owner.steer(Action.UNFREEZE, false, other.number()));
    assertEquals("", owner.steer(Action.STOP, false, other.number()));
    while (owner.look().jobs.containsKey(other.number())) {
      // It ends when its turn comes.
    }
    assertEquals(
        "no such job any more: " + other.number(), owner.steer(Action.STOP, false, other.number()));
    assertEquals("no such tag any more: 123456", owner.steer(Action.STOP, true, 123_456));
    assertEquals(
        "a job can be stopped and frozen; only a tag can be blocked",
        owner.steer(Action.BLOCK, false, owner.await(row -> true).number()));
  }

  @Test
  void observersSeeAndCannotChange() {
    program.say("mine: sleep(1h),");
    Viewer observer = new Viewer(kernel, Role.OBSERVER);
    JobRow job = observer.under("mine");
    for (Action action : List.of(Action.STOP, Action.FREEZE, Action.UNFREEZE)) {
      String refused = observer.steer(action, false, job.number());
      assertTrue(refused.contains("needs the role owner"), refused);
    }
    for (Action action : Action.values()) {
      String refused = observer.steer(action, true, observer.tag("mine").number());
      assertTrue(refused.contains("needs the role owner"), refused);
    }
    assertEquals(job, owner.under("mine"));
  }

  @Test
  void closedConnectionsAnswerNobody() {
    Viewer gone = new Viewer(kernel, Role.OWNER);
    gone.look().client.connection().close();
    while (!"closed".equals(gone.client.next())) {
      // What it was told before.
    }
    assertThrows(CancellationException.class, gone::look);
  }

  /** Nobody could ask for it, as the kernel has ended then. */
  @Test
  void whatHasChangedUntilTheEndIsTold() throws Exception {
    Kernel ending = Kernel.builder().log(line -> {}).start();
    TestClient coder = new TestClient(ending, Role.OWNER);
    coder.say("many: for& (2000) sleep(1h), stays: sleep(1h), goes: sleep(1h),");
    Viewer viewer = new Viewer(ending, Role.OWNER);
    long stays = viewer.under("stays").number();
    long goes = viewer.under("goes").number();
    long many = viewer.tag("many").number();
    ViewRequest wanted = looking(stays);
    viewer.look(wanted);
    List<View> told = new ArrayList<>();
    viewer.client.connection().lookAtEnd(() -> wanted, told::add);
    coder.say("stays.freeze; goes.stop; many.freeze;");
    ending.close();
    assertTrue(told.size() > 1 && told.getLast().complete(), "each has a limited number");
    List<JobRow> rows = told.stream().flatMap(each -> each.jobs().stream()).toList();
    assertTrue(rows.stream().anyMatch(row -> row.number() == stays && row.frozen()));
    assertTrue(
        rows.stream().filter(row -> row.tags().contains(many) && row.frozen()).count() >= 2000);
    assertTrue(told.stream().anyMatch(each -> each.gone().contains(goes)));
  }

  /** It is told before the process is halted, in the turn of the job that does that. */
  @Test
  void whoHaltsTheProcessIsTold() {
    List<View> told = new ArrayList<>();
    CompletableFuture<Integer> toldBefore = new CompletableFuture<>();
    Kernel halting =
        Kernel.builder().log(line -> {}).onHalt(status -> toldBefore.complete(told.size())).start();
    TestClient coder = new TestClient(halting, Role.OWNER);
    Viewer viewer = new Viewer(halting, Role.OWNER);
    viewer.look();
    viewer.client.connection().lookAtEnd(() -> looking(), told::add);
    coder.connection().send("halts: System._exit(3),\n");
    assertTrue(toldBefore.join() > 0);
    assertTrue(
        told.stream()
            .flatMap(each -> each.tags().stream())
            .anyMatch(t -> t.name().equals("halts")));
    halting.close();
  }

  @Test
  void recordedRunContainsWhatWasDone(@TempDir Path folder) {
    Path recording = folder.resolve("run");
    try (Kernel recorded = Kernel.builder().log(line -> {}).record(recording).start()) {
      TestClient coder = new TestClient(recorded, Role.OWNER);
      coder.say("var Global.n = 0|; at (n > 100) echo(\"far\"); count: every (1ms) { n++ },");
      Viewer viewer = new Viewer(recorded, Role.OWNER);
      TagRow count = viewer.tag("count");
      viewer.steer(Action.FREEZE, true, count.number());
      coder.say("sleep(5ms); echo(n);");
      viewer.steer(Action.UNFREEZE, true, count.number());
      coder.say("sleep(5ms);");
      viewer.steer(Action.STOP, true, count.number());
      coder.say("echo(n); echo(System.cycle);");
    }
    ReplayedRun.check(recording);
  }
}
