package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Jobs in line. */
class JobListTest {
  private final Loop loop = new Loop();
  private final JobList queue = new JobList();
  private final Job one = job();
  private final Job two = job();
  private final Job three = job();

  /** One that no scheduler knows. */
  private Job job() {
    return new Job(
        loop.scheduler, self -> {}, "test", loop.object(), loop.scheduler.rootScope(), null, 0);
  }

  @Test
  void jobsComeOutInTheirOrder() {
    queue.add(two.turn);
    queue.add(three.turn);
    queue.addFirst(one.turn);
    assertEquals(3, queue.size());
    assertSame(one, queue.poll());
    assertSame(three, queue.pollLast());
    assertSame(two, queue.poll());
    assertNull(queue.poll());
    assertNull(queue.pollLast());
    assertTrue(queue.isEmpty());
  }

  @Test
  void jobIsInOneQueueAtATime() {
    JobList other = new JobList();
    queue.add(one.turn);
    queue.add(two.turn);
    queue.add(one.turn);
    other.add(two.turn);
    other.addFirst(one.turn);
    assertEquals(2, queue.size());
    assertTrue(other.isEmpty());
    assertSame(one, queue.poll());
    other.add(one.turn);
    assertSame(two, queue.poll());
    assertSame(one, other.poll());
  }

  /** Who is visited may end thereby. */
  @Test
  void jobsAreInTheirOrderUntilTheyLeave() {
    queue.add(one.turn);
    queue.add(two.turn);
    queue.add(three.turn);
    List<Job> all = new ArrayList<>();
    queue.addTo(all);
    assertEquals(List.of(one, two, three), all);
    all.forEach(job -> job.turn.leave());
    assertTrue(queue.isEmpty());
    queue.addTo(all);
    assertEquals(3, all.size());
  }

  /** The place among those that can run is another one than that in the scope. */
  @Test
  void jobIsInAListForEachPurpose() {
    JobList other = new JobList();
    assertTrue(queue.add(one.turn));
    assertTrue(other.add(one.listed));
    assertFalse(other.add(one.turn));
    assertSame(queue, one.turn.leave());
    assertSame(one, other.first());
    assertSame(other, one.listed.leave());
    assertNull(one.listed.leave());
  }

  @Test
  void jobLeavesFromAnywhere() {
    queue.add(one.turn);
    queue.add(two.turn);
    queue.add(three.turn);
    two.turn.leave();
    two.turn.leave();
    assertFalse(queue.hasAny(job -> job == two));
    assertTrue(queue.hasAny(job -> job == three));
    three.turn.leave();
    queue.add(two.turn);
    assertSame(one, queue.poll());
    assertSame(two, queue.poll());
    assertEquals(0, queue.size());
  }
}
