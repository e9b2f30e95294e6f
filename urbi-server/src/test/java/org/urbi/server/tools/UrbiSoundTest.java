package org.urbi.server.tools;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class UrbiSoundTest {
  /** 16 samples of two bytes. */
  private static final String SAMPLES = "0123456789abcdefghijklmnopqrstuv";

  @TempDir Path folder;
  private TestServer server;

  @BeforeEach
  void serve() throws Exception {
    server = new TestServer();
    server
        .kernel()
        .eval(
            """
            class Global.micro { UVar.new(this, "val") };
            class Global.speaker { UVar.new(this, "val") };
            micro.val = 0;
            speaker.val = 0;
            function hear(var header, var samples) { micro.val = Binary.new(header, samples) };
            """);
  }

  @AfterEach
  void close() {
    server.close();
  }

  private ToolResult run(String... options) {
    String[] all = Arrays.copyOf(options, options.length + 1);
    all[options.length] = server.port();
    return ToolResult.of(UrbiSound::run, all);
  }

  private File wav(String... options) {
    File file = folder.resolve("heard.wav").toFile();
    String[] all = Arrays.copyOf(options, options.length + 1);
    all[options.length] = "--output=" + file;
    ToolResult run = run(all);
    assertEquals(0, run.status(), run.err());
    assertTrue(run.err().startsWith("urbi-sound: " + file), run.err());
    return file;
  }

  private void hearAgainAndAgain(String header) {
    server
        .kernel()
        .eval("detach({ every (50ms) hear(\"" + header + "\", \"" + SAMPLES + "\") }) | {}");
  }

  @Test
  void soundsAreSavedOneAfterTheOther() throws Exception {
    hearAgainAndAgain("raw 1 16000 16 1");
    try (AudioInputStream in = AudioSystem.getAudioInputStream(wav("--duration=1"))) {
      AudioFormat format = in.getFormat();
      assertEquals(16_000, format.getSampleRate());
      assertEquals(16, format.getSampleSizeInBits());
      assertEquals(1, format.getChannels());
      byte[] heard = in.readAllBytes();
      assertTrue(heard.length >= 3 * SAMPLES.length(), "several in a second: " + heard.length);
      assertEquals(0, heard.length % SAMPLES.length());
      for (int i = 0; i < heard.length; i++) {
        assertEquals(SAMPLES.charAt(i % SAMPLES.length()), heard[i]);
      }
    }
  }

  @Test
  void theHeaderMayBeLeftOut() throws Exception {
    hearAgainAndAgain("raw 1 16000 16 1");
    byte[] bare = Files.readAllBytes(wav("-D", "1", "--no-header").toPath());
    assertArrayEquals(
        SAMPLES.getBytes(StandardCharsets.US_ASCII), Arrays.copyOf(bare, SAMPLES.length()));
  }

  @Test
  void otherKindsOfSoundsAreMadeLikeTheFirst() throws Exception {
    server
        .kernel()
        .eval(
            """
            var Global.turn = 0;
            detach({
              every (50ms)
              {
                turn += 1 |
                if (turn %% 2)
                  hear("raw 1 16000 16 1", "%1$s")
                else
                  hear("raw 2 8000 8 2", "%1$s")
              }
            }) | {};
            """
                .formatted(SAMPLES));
    File file = wav("-D1");
    try (AudioInputStream in = AudioSystem.getAudioInputStream(file)) {
      AudioFormat format = in.getFormat();
      boolean first = format.getSampleRate() == 16_000 && format.getChannels() == 1;
      boolean second = format.getSampleRate() == 8000 && format.getChannels() == 2;
      assertTrue(first || second, format.toString());
      assertTrue(in.getFrameLength() > 32, "both kinds");
    }
  }

  @Test
  void aFileIsPlayedByTheDevice() throws Exception {
    hearAgainAndAgain("raw 1 16000 16 1");
    File file = wav("-D1");
    long samples = Files.size(file.toPath()) - 44;
    assertEquals(new ToolResult(0, "", ""), run("--input=" + file));
    assertEquals("raw 1 16000 16 1", server.kernel().eval("speaker.val.keywords"));
    assertEquals(samples, server.kernel().eval("speaker.val.data.size", double.class));
  }

  private void fails(int status, String message, String... options) {
    ToolResult run = run(options);
    assertEquals(status, run.status(), run.err());
    assertTrue(run.err().startsWith("urbi-sound: ") && run.err().contains(message), run.err());
  }

  @Test
  void mistakesAreReported() throws Exception {
    String file = folder.resolve("x.wav").toString();
    fails(1, "lookup failed: nobody", "-d", "nobody", "-D1", "-o", file);
    fails(1, "micro.val has not changed: nothing was heard", "-D1", "-o", file);
    fails(2, "invalid --duration: 0", "-D0", "-o", file);
    fails(2, "--no-header is about the file of --output", "-n");
    fails(2, "--input records nothing", "-i", file, "-o", file);
    fails(1, "cannot read " + file, "-i", file);
    Files.writeString(Path.of(file), "no sound at all");
    fails(1, "cannot play " + file + ": no WAV file", "-i", file);
    server.kernel().eval("detach({ every (50ms) { micro.val = 12 | micro.val = 13 } }) | {}");
    fails(1, "micro.val is no sound that is understood", "-D1", "-o", file);
  }

  @Test
  void missingSoundOutputIsReportedWithAHint() {
    assumeTrue(AudioSystem.getMixerInfo().length == 0, "skipped: this machine has a sound output");
    fails(1, "no sound output (this machine has none): --output=FILE saves the sound instead");
  }
}
