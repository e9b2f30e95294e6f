package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.journal.Entry;
import org.urbi.kernel.journal.RecordingReader;
import org.urbi.kernel.journal.RecordingWriter;
import org.urbi.kernel.message.Outcome;
import org.urbi.kernel.trust.Role;

/** What a run has learned of its garbage collector is in its recording. */
class RecordedCollectionTest {
  @TempDir Path folder;
  private Path recording;

  @BeforeEach
  void chooseFile() {
    recording = folder.resolve("run");
  }

  private void recordFinalizedObjects() {
    try (Kernel kernel = Kernel.builder().virtualTime(true).record(recording).start()) {
      TestClient client = new TestClient(kernel, Role.OWNER);
      String said =
          client.say(
              """
              var Global.Guest = Finalizable.clone|;
              do (Guest) {
                var name = "nobody";
                function init(given) { var this.name = given };
                function finalize() { echo("bye " + name) | sleep(1s) };
              }|;
              for (var name : ["ann", "bob", "cid"]) Global.setSlot(name, Guest.new(name))|;
              """);
      assertEquals("", said);
      assertEquals(
          "*** bye cid", client.say("Global.removeLocalSlot(\"cid\")|;"), "nobody refers to cid");
      assertEquals(
          "*** bye ann\n*** bye bob",
          client.say("{ Global.removeLocalSlot(\"bob\") | Global.removeLocalSlot(\"ann\") }|;"));
    }
  }

  /** Whatever the collector of the replay does: ann goes before cid, if that is recorded. */
  @Test
  void aReplayFinalizesTheRecordedObjects() throws IOException {
    recordFinalizedObjects();
    ReplayedRun.check(recording);
    Path other = folder.resolve("other");
    try (RecordingReader in = new RecordingReader(Files.newInputStream(recording));
        RecordingWriter out =
            new RecordingWriter("other", Files.newOutputStream(other), trouble -> {})) {
      for (Entry entry = in.next(); entry != null; entry = in.next()) {
        boolean cid = entry.equals(new Entry.QueryAnswered(Outcome.value(List.of(4L))));
        out.write(cid ? new Entry.QueryAnswered(Outcome.value(List.of(2L))) : entry);
      }
    }
    String difference = ReplayedRun.difference(other);
    assertTrue(difference != null && difference.contains("*** bye ann"), difference);
  }

  /** Who is no owner may not stop everybody to have the garbage collected. */
  @Test
  void whatAUserHasMadeIsFinalizedSometime() {
    try (Kernel kernel = Kernel.builder().virtualTime(true).record(recording).start()) {
      TestClient client = new TestClient(kernel, Role.USER);
      assertEquals(
          "",
          client.say(
              """
              var guest = Finalizable.new|;
              function guest.finalize() { echo("bye") }|;
              guest = nil|;
              """));
      String said = "";
      while (said.isEmpty()) {
        System.gc();
        said = client.say("1|;");
      }
      assertEquals("*** bye", said);
    }
    ReplayedRun.check(recording);
  }

  /** Links end with their variables, at the same moment in each run and in its replay. */
  @Test
  void linksOfVariablesThatComeAndGoAreNotListed() {
    try (Kernel kernel = Kernel.builder().virtualTime(true).record(recording).start()) {
      TestClient client = new TestClient(kernel, Role.OWNER);
      assertEquals(
          "",
          client.say(
              """
              function Global.linked(value) {
                var from = Object.clone | UVar.new(from, "x") | from.x = value |
                var to = Object.clone | UVar.new(to, "y") |
                from.&x >> to.&y |
                from
              }|;
              var Global.one = linked(1)|;
              for (200) linked(2)|;
              var Global.two = linked(3)|;
              """));
      assertEquals("2", client.say("Subscription.getAll.size;"));
      assertEquals("1", client.say("Global.removeLocalSlot(\"one\")|; Subscription.getAll.size;"));
      client.say("uobjects.connectionStats;");
    }
    ReplayedRun.check(recording);
  }
}
