# Compiles FILE as it is, which must fail with a message that matches EXPECTED, and with COMPLETE defined, which must
# succeed: otherwise the first failure would prove nothing.
separate_arguments(FLAGS)
execute_process(COMMAND ${COMPILER} ${FLAGS} -fsyntax-only -DCOMPLETE ${FILE} RESULT_VARIABLE status ERROR_VARIABLE text)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "with the column it should compile:\n${text}")
endif()
execute_process(COMMAND ${COMPILER} ${FLAGS} -fsyntax-only ${FILE} RESULT_VARIABLE status ERROR_VARIABLE text)
if(status EQUAL 0)
    message(FATAL_ERROR "without the column it should not compile")
endif()
if(NOT text MATCHES "${EXPECTED}")
    message(FATAL_ERROR "the message should match '${EXPECTED}':\n${text}")
endif()
