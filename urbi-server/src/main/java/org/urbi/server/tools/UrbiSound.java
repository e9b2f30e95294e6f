package org.urbi.server.tools;

import static java.util.Objects.requireNonNullElse;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.urbi.kernel.log.Defects;
import org.urbi.server.options.Arguments;
import org.urbi.server.options.Failure;
import org.urbi.server.options.Program;
import urbi.UCallbackAction;
import urbi.UClientException;
import urbi.UConversion;
import urbi.UConversionException;
import urbi.UDataType;
import urbi.UMessage;
import urbi.USound;
import urbi.USoundFormat;
import urbi.USyncClient;
import urbi.UValue;

/**
 * The program {@code urbi-sound}: records what a device of a running server hears, and plays or
 * saves it (manual, section 21.9). It also has a device play a file.
 */
public final class UrbiSound {
  private static final String MICROPHONE = "micro";
  private static final String LOUDSPEAKER = "speaker";
  private static final int DEFAULT_SECONDS = 10;
  private static final int MAX_SECONDS = 24 * 3600;
  private static final Duration TIMEOUT = Duration.ofSeconds(20);

  private final PrintStream err;

  private UrbiSound(PrintStream err) {
    this.err = err;
  }

  public static void main(String[] args) {
    System.exit(run(args, System.out, System.err));
  }

  /** Runs the program and returns its exit status. */
  public static int run(String[] args, PrintStream out, PrintStream err) {
    Program program = new Program("urbi-sound", "Records sounds of a running Urbi server.");
    return ServerAddress.options(program)
        .option(
            "DEVICE",
            "Query sounds on DEVICE.val (default: "
                + MICROPHONE
                + "; with --input: "
                + LOUDSPEAKER
                + ").",
            "-d",
            "--device")
        .option(
            "DURATION",
            "How many seconds are recorded (default: " + DEFAULT_SECONDS + ").",
            "-D",
            "--duration")
        .flag("Save samples alone, without the header of a WAV file.", "-n", "--no-header")
        .option("FILE", "Save the sound to FILE, and do not play it.", "-o", "--output")
        .option("FILE", "Record nothing: send the WAV file FILE to DEVICE.val.", "-i", "--input")
        .run(args, out, err, new UrbiSound(err)::work);
  }

  private int work(Arguments arguments) {
    ServerAddress target = ServerAddress.of(arguments, arguments.value("--host", "127.0.0.1"));
    String input = arguments.value("--input");
    if (input != null) {
      if (arguments.has("--output")
          || arguments.has("--duration")
          || arguments.has("--no-header")) {
        throw Failure.usage("--input records nothing: no --output, --duration or --no-header");
      }
      return send(target, arguments.value("--device", LOUDSPEAKER), Path.of(input));
    }
    String output = arguments.value("--output");
    if (output == null && arguments.has("--no-header")) {
      throw Failure.usage("--no-header is about the file of --output");
    }
    String device = arguments.value("--device", MICROPHONE);
    int seconds = arguments.number("--duration", DEFAULT_SECONDS, 1, MAX_SECONDS);
    SoundRecorder recording = new SoundRecorder(output == null ? new Loudspeaker() : null);
    try (recording;
        USyncClient client = target.client()) {
      record(client, device, seconds, recording);
      if (recording.sounds() == 0) {
        throw Failure.of(device + ".val has not changed: nothing was heard");
      }
      if (output != null) {
        save(recording.sound(), Path.of(output), arguments.has("--no-header"));
      }
      return 0;
    } catch (UClientException e) {
      throw Failure.of(e.getMessage());
    }
  }

  /** Makes the server send each new value of the device, for some time. */
  private static void record(
      USyncClient client, String device, int seconds, SoundRecorder recording) {
    String tag = client.fresh();
    CompletableFuture<Void> done = new CompletableFuture<>();
    client.setCallback(message -> take(message, device, recording, done), tag);
    // Asking for the value reveals a missing device at once.
    client.syncGet(TIMEOUT, device + ".val | 0");
    client.syncGet(
        TIMEOUT.plusSeconds(seconds),
        """
        var '$sounds' = Channel.new("%s") |
        '$sounds'.quote = true |
        timeout (%ds) { at (%s.val->changed?) '$sounds' << %s.val; sleep(inf) } |
        '$sounds' << "end" |
        0
        """
            .formatted(tag, seconds, device, device));
    try {
      done.get(TIMEOUT.toSeconds() + seconds, TimeUnit.SECONDS);
    } catch (ExecutionException e) {
      if (e.getCause() instanceof Failure failure) {
        throw failure;
      }
      throw Failure.of(device + ".val: " + requireNonNullElse(e.getCause(), e).getMessage());
    } catch (TimeoutException e) {
      throw Failure.of("the server does not say when it is done");
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static UCallbackAction take(
      UMessage message, String device, SoundRecorder recording, CompletableFuture<Void> done) {
    UValue value = message.getValue();
    try {
      if (value.getType() == UDataType.DATA_STRING) {
        done.complete(null);
        return UCallbackAction.URBI_REMOVE;
      }
      recording.add(value.usoundValue());
      return UCallbackAction.URBI_CONTINUE;
    } catch (Failure e) {
      done.completeExceptionally(e);
      return UCallbackAction.URBI_REMOVE;
    } catch (RuntimeException e) {
      String why = Defects.text("the recording of a sound", e);
      done.completeExceptionally(
          Failure.of(device + ".val is no sound that is understood: " + why));
      return UCallbackAction.URBI_REMOVE;
    }
  }

  private void save(USound raw, Path file, boolean bare) {
    try {
      USound saved = new USound();
      saved.setSoundFormat(bare ? USoundFormat.SOUND_RAW : USoundFormat.SOUND_WAV);
      UConversion.convert(raw, saved);
      Files.write(file, saved.getData());
    } catch (IOException e) {
      throw Failure.of("cannot write " + file + ": " + e);
    }
    double seconds = raw.getSize() * 8.0 / raw.getSampleSize() / raw.getChannels() / raw.getRate();
    err.println(
        "urbi-sound: %s: %.2f s, %d Hz, %d bits, %d channel(s)"
            .formatted(file, seconds, raw.getRate(), raw.getSampleSize(), raw.getChannels()));
  }

  private int send(ServerAddress target, String device, Path file) {
    USound wav = new USound();
    try {
      wav.setSoundFormat(USoundFormat.SOUND_WAV);
      wav.setData(Files.readAllBytes(file));
      USound raw = new USound();
      raw.setSoundFormat(USoundFormat.SOUND_RAW);
      UConversion.convert(wav, raw);
      wav = raw;
    } catch (IOException e) {
      throw Failure.of("cannot read " + file + ": " + e);
    } catch (UConversionException e) {
      throw Failure.of("cannot play " + file + ": " + e.getMessage());
    }
    try (USyncClient client = target.client()) {
      client.syncGet(TIMEOUT, device + ".hasSlot(\"val\")");
      client.sendSound(device, wav);
      client.syncGet(TIMEOUT, "0");
      return 0;
    } catch (UClientException e) {
      throw Failure.of(e.getMessage());
    }
  }
}
