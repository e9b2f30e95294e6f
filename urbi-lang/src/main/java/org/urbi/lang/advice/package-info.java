/** What people are told about mistakes, beyond the message: hints, and the places concerned. */
@NullMarked
package org.urbi.lang.advice;

import org.jspecify.annotations.NullMarked;
