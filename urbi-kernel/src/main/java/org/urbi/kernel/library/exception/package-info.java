/** The exceptions that the language throws (manual, "Exception"). */
package org.urbi.kernel.library.exception;
