package org.urbi.server.studio;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Client;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.journal.Entry;
import org.urbi.kernel.journal.RecordingReader;
import org.urbi.kernel.message.Message;
import org.urbi.server.studio.files.Folders;
import org.urbi.server.trust.AccessPolicy;

/** Whatever people do in the studio is in the recording of the run, and done again in a replay. */
class StudioRecordingTest {
  private static final String PROGRAM =
      "var Global.x = 0|; var Global.e = Event.new|; var Global.y = 0|; at (e?(var n)) y += n;";

  @TempDir Path folder;

  private static void done(StreamClient page, int id) throws InterruptedException {
    String answer = page.await("\"done\",\"id\":" + id + ",");
    assertTrue(answer.startsWith("{\"type\":\"done\",\"id\":" + id + ",\"error\":\"\""), answer);
  }

  /** Each kind of intervention, as the rooms of the studio send it. */
  private static void intervene(StreamClient page) throws InterruptedException {
    page.send("{\"type\":\"run\",\"id\":0,\"file\":\"code\",\"code\":\"" + PROGRAM + "\"}");
    done(page, 0);
    page.send("{\"type\":\"reactions\",\"filter\":\"\"}");
    String event =
        page.await("\"name\":\"e\"").replaceFirst(".*\"number\":(\\d+),\"name\":\"e\".*", "$1");
    page.send("{\"type\":\"emit\",\"id\":1,\"event\":" + event + ",\"payload\":\"20 + 1\"}");
    done(page, 1);
    page.send("{\"type\":\"assign\",\"id\":2,\"way\":\"Global\\n.x\",\"value\":\"6 * 7\"}");
    done(page, 2);
    page.send(
        "{\"type\":\"run\",\"id\":3,\"file\":\"code\",\"code\":\"waituntil (y == 21); echo(x); mine: sleep(1h)\"}");
    String mine =
        page.await("\"name\":\"mine\"")
            .replaceFirst(".*\"number\":(\\d+),\"name\":\"mine\".*", "$1");
    page.send(
        "{\"type\":\"steer\",\"id\":4,\"action\":\"freeze\",\"kind\":\"tag\",\"target\":"
            + mine
            + "}");
    done(page, 4);
    page.send("{\"type\":\"stop\",\"id\":5,\"run\":2}");
    done(page, 5);
    page.send("{\"type\":\"save\",\"id\":6,\"name\":\"new.u\",\"text\":\"1 €\",\"version\":\"\"}");
    done(page, 6);
    page.send("{\"type\":\"open\",\"id\":7,\"name\":\"new.u\"}");
    done(page, 7);
  }

  private static List<String> interventions(Path recording) throws IOException {
    List<String> all = new ArrayList<>();
    try (RecordingReader in = new RecordingReader(Files.newInputStream(recording))) {
      for (Entry entry = in.next(); entry != null; entry = in.next()) {
        if (entry instanceof Entry.MessageTaken(Message message)) {
          switch (message) {
            case Message.Emitted emitted -> all.add("emit " + emitted.payload());
            case Message.Assigned assigned -> all.add("assign " + assigned.value());
            case Message.CodeRun run -> all.add("run " + run.code());
            case Message.Steered steered -> all.add("steer " + steered.action());
            case Message.CodeStopped stopped -> all.add("stop " + stopped.run());
            case Message.FileSaved saved -> all.add("save " + saved.text());
            case Message.FileOpened opened -> all.add("open " + opened.name());
            default -> {}
          }
        }
      }
    }
    return all;
  }

  @Test
  void eachInterventionIsRecordedAndReplayed() throws Exception {
    Path recording = folder.resolve("run");
    Path files = Files.createDirectory(folder.resolve("files"));
    try (Kernel kernel = Kernel.builder().log(line -> {}).record(recording).start();
        StudioServer studio =
            Served.of(kernel, AccessPolicy.ALL, Shown.VARIABLES, new Folders(files, null));
        StreamClient page = new StreamClient(studio, "/stream")) {
      intervene(page);
    }
    assertEquals(
        List.of(
            "run " + PROGRAM,
            "emit 20 + 1",
            "assign 6 * 7",
            "run waituntil (y == 21); echo(x); mine: sleep(1h)",
            "steer freeze",
            "stop 2",
            "save 1 €",
            "open new.u"),
        interventions(recording));
    Files.delete(files.resolve("new.u"));
    StringBuilder shown = new StringBuilder();
    Client silent =
        new Client() {
          @Override
          public void output(String bytes) {
            shown.append(bytes);
          }

          @Override
          public void closed() {}
        };
    Kernel replayed = Kernel.builder().log(line -> {}).replay(recording, number -> silent).start();
    replayed.awaitTermination();
    assertNull(replayed.replayDifference());
    assertEquals("*** 42", shown.substring(shown.indexOf("***")).strip());
    assertFalse(Files.exists(files.resolve("new.u")), "a replay changes nothing outside");
  }
}
