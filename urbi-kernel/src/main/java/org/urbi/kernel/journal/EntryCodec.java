package org.urbi.kernel.journal;

import static java.util.Objects.requireNonNull;

import java.lang.reflect.Constructor;
import java.lang.reflect.RecordComponent;
import java.util.HashMap;
import java.util.Map;
import org.urbi.kernel.message.Message;

/**
 * The serial form of entries and messages: a number for the kind, then the components in their
 * order. Numbers are never used again for something else; a component more is another kind.
 */
public final class EntryCodec {
  private static final Map<Integer, Kind> BY_NUMBER = new HashMap<>();
  private static final Map<Class<?>, Kind> BY_TYPE = new HashMap<>();

  static {
    add(2, Entry.Tick.class);
    add(3, Entry.MessageTaken.class);
    add(4, Entry.QueryAnswered.class);
    add(6, Entry.JobInterrupted.class);
    add(7, Entry.BytesSent.class);
    add(8, Entry.RunEnded.class);
    add(9, Entry.JobOverdue.class);
    add(10, Entry.RoundCut.class);
    add(11, Entry.RunStarted.class);
    add(12, Entry.JobGreedy.class);
    add(13, Entry.MessageTakenAtOnce.class);
    add(14, Entry.ObjectMissed.class);
    add(15, Entry.NewsWaited.class);
    add(16, Entry.SwitchRefused.class);
    add(17, Entry.SwitchTriedAgain.class);
    add(20, Message.Shutdown.class);
    add(23, Message.ConsoleBytes.class);
    add(24, Message.InputEnded.class);
    add(25, Message.Interrupted.class);
    add(26, Message.ConnectionClosed.class);
    add(27, Message.CompletionRequested.class);
    add(28, Message.ConnectionFailed.class);
    add(30, Message.RoleGranted.class);
    add(31, Message.Evicted.class);
    add(32, Message.HungUp.class);
    add(33, Message.LookedAt.class);
    add(34, Message.LookEnded.class);
    add(35, Message.Steered.class);
    add(36, Message.Emitted.class);
    add(37, Message.Assigned.class);
    add(38, Message.CodeRun.class);
    add(39, Message.CodeStopped.class);
    add(40, Message.RemoteOpened.class);
    add(41, Message.RemoteFrame.class);
    add(42, Message.RemoteCongested.class);
    add(43, Message.RemoteDrained.class);
    add(44, Message.RemoteLost.class);
    add(45, Message.RemoteReadable.class);
    add(46, Message.PollingRequested.class);
    add(47, Message.ConnectionOpened.class);
    add(5, Entry.YieldedToMessages.class);
    add(50, Message.FeedBegun.class);
    add(51, Message.Followed.class);
    add(52, Message.ValuesAsked.class);
    add(53, Message.ValueGiven.class);
    add(54, Message.FileOpened.class);
    add(55, Message.FileSaved.class);
    add(56, Message.FunctionCalled.class);
    add(60, Message.Answer.class);
    add(61, Message.BytesArrived.class);
    add(62, Message.BytesEnded.class);
    add(63, Message.BytesWritten.class);
    add(64, Message.WritingFailed.class);
    add(65, Message.ProcessEnded.class);
    add(66, Message.Accepted.class);
    add(67, Message.ListeningEnded.class);
    add(68, Message.FileCreated.class);
    add(69, Message.FileDeleted.class);
    add(80, Message.ComponentCode.class);
    add(81, Message.ComponentCall.class);
    add(82, Message.ComponentEvent.class);
    add(83, Message.ComponentRequest.class);
    add(84, Message.ComponentDone.class);
    add(85, Message.ComponentGone.class);
    add(86, Message.VariableWanted.class);
    add(87, Message.EventWanted.class);
    add(88, Message.ObjectWanted.class);
    add(89, Message.VariableRead.class);
    add(90, Message.VariableWritten.class);
    add(91, Message.PropertyRead.class);
    add(92, Message.PropertyWritten.class);
    add(93, Message.VariableUsed.class);
    add(94, Message.VariableUnnotified.class);
    add(95, Message.ClassStarted.class);
    add(96, Message.KernelLocked.class);
    add(97, Message.AskedWhileLocked.class);
    add(98, Message.KernelUnlocked.class);
    add(101, Message.EmbeddingCancel.class);
    add(102, Message.EmbeddingWaits.class);
    add(103, Message.SourceEvaluated.class);
    add(104, Message.MethodCalled.class);
    add(105, Message.ObjectCalled.class);
    add(106, Message.SlotRead.class);
    add(107, Message.SlotWritten.class);
    add(108, Message.SlotSought.class);
    add(109, Message.SlotRemoved.class);
    add(110, Message.SlotsListed.class);
    add(111, Message.ObjectShown.class);
    add(112, Message.ScopeWanted.class);
    add(113, Message.Listened.class);
    add(114, Message.FunctionDefined.class);
    add(115, Message.ProgramEvicted.class);
  }

  private record Kind(int number, RecordComponent[] parts, Constructor<?> constructor) {}

  private EntryCodec() {}

  private static void add(int number, Class<? extends Record> type) {
    RecordComponent[] parts = type.getRecordComponents();
    Class<?>[] types = new Class<?>[parts.length];
    for (int i = 0; i < types.length; i++) {
      types[i] = parts[i].getType();
    }
    try {
      Kind kind = new Kind(number, parts, type.getDeclaredConstructor(types));
      BY_NUMBER.put(number, kind);
      BY_TYPE.put(type, kind);
    } catch (NoSuchMethodException e) {
      throw new ExceptionInInitializerError(e);
    }
  }

  /** Writes an entry, or a message. */
  static void write(DataWriter out, Object entry) {
    Kind kind = requireNonNull(BY_TYPE.get(entry.getClass()), "every entry has its form");
    out.octet(kind.number);
    try {
      for (RecordComponent part : kind.parts) {
        out.part(part.getType(), part.getAccessor().invoke(entry));
      }
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
  }

  /**
   * Reads an entry, or a message.
   *
   * @throws RecordingException if there is none
   */
  static Object read(DataReader in) {
    int number = in.octet();
    Kind kind = BY_NUMBER.get(number);
    if (kind == null) {
      throw new RecordingException("has an entry of an unknown kind, " + number);
    }
    Object[] values = new Object[kind.parts.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = in.part(kind.parts[i].getType());
    }
    try {
      return kind.constructor.newInstance(values);
    } catch (ReflectiveOperationException e) {
      throw new RecordingException("has an entry that makes no sense: " + e.getCause());
    }
  }
}
