package org.urbi.server.tools;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.GeneralSecurityException;
import java.security.Key;
import java.security.KeyStore;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.stream.Collectors;
import org.urbi.server.options.Arguments;
import org.urbi.server.options.Failure;
import org.urbi.server.options.Program;

/**
 * The program {@code urbi-certificate}: makes a private key and a certificate that it signs itself,
 * for {@code urbi --tls-certificate} and {@code --tls-key}. The JDK's {@code keytool} makes them.
 */
public final class UrbiCertificate {
  private static final String ALIAS = "urbi";
  private static final int DAYS = 825;
  private static final int MAX_DAYS = 36_500;
  private static final String ADDRESS = "[0-9.]+|.*:.*";

  /** Of the store, which nobody else can read and which is gone at the end. */
  private static final String PASSWORD = "changeit";

  private final PrintStream out;

  private UrbiCertificate(PrintStream out) {
    this.out = out;
  }

  public static void main(String[] args) {
    System.exit(run(args, System.out, System.err));
  }

  /** Runs the program and returns its exit status. */
  public static int run(String[] args, PrintStream out, PrintStream err) {
    return new Program(
            "urbi-certificate",
            "Makes FILE.crt, a certificate that signs itself, and FILE.key, its private key.")
        .option("DAYS", "How long it is valid (default: " + DAYS + ").", "--days")
        .arguments(
            "FILE [HOST]...",
            "The names and addresses by which clients connect (default: localhost 127.0.0.1 ::1).")
        .run(args, out, err, new UrbiCertificate(out)::make);
  }

  private int make(Arguments arguments) {
    List<String> rest = arguments.rest();
    if (rest.isEmpty()) {
      throw Failure.usage("no FILE: where are the certificate and its key to be?");
    }
    List<String> hosts =
        rest.size() > 1 ? rest.subList(1, rest.size()) : List.of("localhost", "127.0.0.1", "::1");
    Path certificate = Path.of(rest.getFirst() + ".crt");
    Path key = Path.of(rest.getFirst() + ".key");
    try {
      Path folder = Files.createTempDirectory("urbi-certificate");
      Path store = folder.resolve("store");
      try {
        make(store, hosts, arguments.number("--days", DAYS, 1, MAX_DAYS));
        write(store, certificate, key);
      } finally {
        Files.deleteIfExists(store);
        Files.delete(folder);
      }
    } catch (FileAlreadyExistsException e) {
      throw Failure.of("there is a " + e.getMessage() + " already");
    } catch (IOException | GeneralSecurityException e) {
      throw Failure.of("cannot make a certificate: " + e.getMessage());
    }
    out.println("certificate, for clients as well: " + certificate);
    out.println("private key, for the server alone: " + key);
    return 0;
  }

  private static void make(Path store, List<String> hosts, int days) throws IOException {
    String names =
        hosts.stream()
            .map(host -> (host.matches(ADDRESS) ? "ip:" : "dns:") + host)
            .collect(Collectors.joining(","));
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "keytool").toString(),
                // It lives for a second: the second compiler would take half of that.
                "-J-XX:TieredStopAtLevel=1",
                "-J-XX:+UseSerialGC",
                "-genkeypair",
                "-alias",
                ALIAS,
                "-keyalg",
                "EC",
                "-groupname",
                "secp256r1",
                "-validity",
                String.valueOf(days),
                "-dname",
                "CN=Urbi server",
                "-ext",
                "san=" + names,
                "-storetype",
                "PKCS12",
                "-keystore",
                store.toString(),
                "-storepass",
                PASSWORD));
    Process keytool = new ProcessBuilder(command).redirectErrorStream(true).start();
    String said =
        new String(keytool.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
    try {
      if (keytool.waitFor() != 0) {
        throw new IOException(said);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    }
  }

  private static void write(Path store, Path certificate, Path key)
      throws IOException, GeneralSecurityException {
    KeyStore made = KeyStore.getInstance(store.toFile(), PASSWORD.toCharArray());
    Key secret = made.getKey(ALIAS, PASSWORD.toCharArray());
    write(key, "rw-------", "PRIVATE KEY", secret.getEncoded());
    write(certificate, "rw-r--r--", "CERTIFICATE", made.getCertificate(ALIAS).getEncoded());
  }

  /** Never over something that is there: a lost key does not come back. */
  private static void write(Path file, String permissions, String what, byte[] bytes)
      throws IOException {
    FileAttribute<?> attribute =
        PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString(permissions));
    Files.createFile(file, attribute);
    String lines = Base64.getMimeEncoder(64, new byte[] {'\n'}).encodeToString(bytes);
    Files.writeString(
        file, "-----BEGIN %1$s-----\n%2$s\n-----END %1$s-----\n".formatted(what, lines));
  }
}
