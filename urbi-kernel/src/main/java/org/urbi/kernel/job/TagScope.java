package org.urbi.kernel.job;

import static java.util.Objects.requireNonNull;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * One execution of code under one tag. Scopes form a tree: code under a tag runs other tagged code,
 * and starts jobs which inherit the innermost scope of their parent. Whatever is done to a tag is
 * done to the subtrees of its scopes.
 */
public final class TagScope {
  /** Something that waits under a scope without a job of its own, such as an event handler. */
  public interface Attachment {
    /**
     * The scope was stopped: it must wait no longer.
     *
     * @param by the scope whose tag was stopped; null if no clause must be executed
     */
    void stopped(@Nullable TagScope by);

    /** What waits: itself, unless it stands for another one that may be gone; then null. */
    default @Nullable Attachment handler() {
      return this;
    }

    /** Whether what it waits for can no longer happen. */
    default boolean isGone() {
      return false;
    }
  }

  private static final int SWEPT_FROM = 16;

  private final TagState tag;
  private final @Nullable TagScope parent;
  private final @Nullable Job owner;
  private final int depth;
  private final Set<TagScope> inner = new LinkedHashSet<>();
  private final JobList jobs = new JobList();
  private final Set<Attachment> attachments = new LinkedHashSet<>();
  private int sweptAt = SWEPT_FROM;
  private boolean closed;
  private long statement;
  private int stops;
  private boolean over;
  private boolean abandoned;
  private boolean shelter;

  /** The root of the tree of a kernel: under no tag at all. */
  TagScope() {
    this(new TagState(), null, null);
  }

  /**
   * @param owner the job that has entered the tagged code and will leave it; null if all jobs of
   *     the scope begin and end under it
   */
  TagScope(TagState tag, @Nullable TagScope parent, @Nullable Job owner) {
    this.tag = tag;
    this.parent = parent;
    this.owner = owner;
    this.depth = parent == null ? 0 : parent.depth + 1;
    if (parent != null) {
      parent.inner.add(this);
    }
    tag.scopes.add(this);
  }

  /** A scope under a tag, for other jobs; to be {@linkplain #end ended}. */
  public static TagScope branch(Scheduler scheduler, TagState tag, TagScope around) {
    scheduler.number(tag);
    return new TagScope(tag, around, null);
  }

  /**
   * A scope for what a job begins that cleans up under an {@linkplain #isAbandoned abandoned} one:
   * the cleaning up is to find handlers and jobs as usual, and none of them is to be left. It ends
   * when the job leaves the scope around it, or at its end.
   */
  static TagScope shelter(TagScope around, Job owner) {
    TagScope made = new TagScope(new TagState(), around, owner);
    made.shelter = true;
    return made;
  }

  /** Whether it is such a scope, and made for that job. */
  boolean isShelterOf(Job job) {
    return shelter && owner == job;
  }

  /** Its owner has left this shelter: what it has begun there ends. */
  void endShelter(Scheduler scheduler) {
    close();
    if (tag.isUsed()) {
      tag.abandon(scheduler, null);
    }
  }

  /** Nobody is left for what runs here: see {@link #isAbandoned}. */
  public void abandon() {
    abandoned = true;
  }

  /** What runs here, below that scope, was abandoned with all the shelters it had found there. */
  void abandonShelters(TagScope above) {
    for (TagScope scope = this; scope != above; scope = scope.parent()) {
      scope.abandoned |= scope.shelter;
    }
  }

  /**
   * Whether all that is here has been told to end for good, because its client has left, so that
   * nobody would end what begins here now.
   */
  public boolean isAbandoned() {
    TagScope scope = this;
    while (!scope.abandoned && !scope.shelter && scope.parent != null) {
      scope = scope.parent;
    }
    return scope.abandoned;
  }

  public TagState tag() {
    return tag;
  }

  /** The surrounding scope; not for the root. */
  public TagScope parent() {
    return requireNonNull(parent, "nobody leaves the root, or stops it");
  }

  /** The surrounding scope; null for the root. */
  @Nullable TagScope around() {
    return parent;
  }

  @Nullable Job owner() {
    return owner;
  }

  int depth() {
    return depth;
  }

  void add(Job job) {
    jobs.add(job.scoped);
  }

  void remove(Job job) {
    job.scoped.leave();
    detachIfOver();
  }

  /** Adds something that waits without a job; it is called when the scope is stopped. */
  public void add(Attachment attachment) {
    attachments.add(attachment);
    if (attachments.size() > sweptAt) {
      attachments.removeIf(Attachment::isGone);
      sweptAt = Math.max(SWEPT_FROM, 2 * attachments.size());
    }
  }

  public void remove(Attachment attachment) {
    attachments.remove(attachment);
    detachIfOver();
  }

  /** The tagged code has been left; the scope lasts as long as what was started under it. */
  void close() {
    closed = true;
    detachIfOver();
  }

  /**
   * Declares that no more jobs will be started under a scope created by {@link #branch} from
   * outside of it.
   */
  public void end() {
    close();
  }

  /** Whether it was ended, and nothing is left under it: then nothing can be started there. */
  public boolean isOver() {
    return over;
  }

  private void detachIfOver() {
    if (parent != null && closed && jobs.isEmpty() && inner.isEmpty() && attachments.isEmpty()) {
      over = true;
      parent.inner.remove(this);
      tag.scopes.remove(this);
      parent.detachIfOver();
    }
  }

  /** Whether a job has entered it whose number is not greater than that. */
  boolean isOf(long last) {
    return owner == null || owner.number() <= last;
  }

  /** What it is for is the statement of that number, of those of a console. */
  public void isForStatement(long number) {
    statement = number;
  }

  /** Whether the code here belongs to a statement of a greater number. */
  public boolean isAfter(long last) {
    for (TagScope scope = this; scope != null; scope = scope.parent) {
      if (scope.statement > last) {
        return true;
      }
    }
    return false;
  }

  /** Whether the code here is in a scope {@linkplain #isOf of} those jobs, under that tag. */
  boolean isWithin(TagState around, long last) {
    for (TagScope scope = this; scope != null; scope = scope.parent) {
      if (scope.tag == around && scope.isOf(last)) {
        return true;
      }
    }
    return false;
  }

  /** Whether the code here is to outlive the connection that started it. */
  boolean isDetached() {
    for (TagScope scope = this; scope != null; scope = scope.parent) {
      if (scope.tag.isDetached()) {
        return true;
      }
    }
    return false;
  }

  /** A stop made in pieces has begun here. */
  void beginStop() {
    stops++;
  }

  /** One of those is over. */
  void endStop() {
    stops--;
  }

  /** Whether handlers here must not react: they are frozen, or about to be stopped. */
  public boolean isSilent() {
    return isFrozen() || isStopping();
  }

  /** Whether handlers here are about to be stopped. */
  public boolean isStopping() {
    for (TagScope scope = this; scope != null; scope = scope.parent) {
      if (scope.stops > 0) {
        return true;
      }
    }
    return false;
  }

  /**
   * Whether a surrounding tag suspends the code here. What is {@linkplain #isAbandoned abandoned}
   * is to clean up and end, although perhaps nobody is left who would unfreeze the tag; what it
   * begins meanwhile, in a shelter, only tags in that shelter suspend.
   */
  public boolean isFrozen() {
    boolean frozen = false;
    for (TagScope scope = this; scope != null; scope = scope.parent) {
      if (scope.abandoned) {
        return false;
      }
      if (scope.shelter) {
        return frozen;
      }
      frozen |= scope.tag.isFrozen();
    }
    return frozen;
  }

  /** The jobs directly under this scope. */
  List<Job> ownJobs() {
    List<Job> own = new ArrayList<>(jobs.size());
    jobs.addTo(own);
    return own;
  }

  /** What waits directly under this scope without a job. */
  List<Attachment> ownAttachments() {
    return new ArrayList<>(attachments);
  }

  /** The scopes directly within this one. */
  List<TagScope> innerScopes() {
    return inner.isEmpty() ? List.of() : new ArrayList<>(inner);
  }

  /** Whether there is a job under this scope. */
  boolean hasJobs() {
    if (!jobs.isEmpty()) {
      return true;
    }
    for (TagScope scope : inner) {
      if (scope.hasJobs()) {
        return true;
      }
    }
    return false;
  }

  /** Everything that waits under this scope without a job. */
  public List<Attachment> allAttachments() {
    List<Attachment> all = new ArrayList<>();
    collectAttachments(all);
    return all;
  }

  private void collectAttachments(List<Attachment> all) {
    all.addAll(attachments);
    for (TagScope scope : inner) {
      scope.collectAttachments(all);
    }
  }

  /** Adds every job under this scope, in the order in which they came. */
  void collect(List<Job> all) {
    jobs.addTo(all);
    for (TagScope scope : inner) {
      scope.collect(all);
    }
  }

  /** The tag of that number, on this scope or below it; null if there is none. */
  public @Nullable TagState tag(long number) {
    Deque<TagScope> left = new ArrayDeque<>();
    for (TagScope scope = this; scope != null; scope = left.poll()) {
      if (scope.tag.number() == number) {
        return scope.tag;
      }
      left.addAll(scope.inner);
    }
    return null;
  }

  /** The surrounding tags, innermost first. */
  public List<TagState> tags() {
    List<TagState> tags = new ArrayList<>();
    for (TagScope scope = this; scope.parent != null; scope = scope.parent) {
      tags.add(scope.tag);
    }
    return tags;
  }
}
